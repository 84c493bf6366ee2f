// Validates glTF files with Khronos' validator: node validate-gltf.js FOLDER-OF-node_modules FILE...
const fs = require('fs');
const path = require('path');
const [, , modules, ...files] = process.argv;
const validator = require(path.join(modules, 'gltf-validator'));
(async () => {
    for (const file of files) {
        const { issues } = await validator.validateBytes(new Uint8Array(fs.readFileSync(file)), { uri: file });
        if (issues.numErrors + issues.numWarnings === 0) continue;
        console.error(file + ': ' + JSON.stringify(issues, null, 1));
        process.exitCode = 1;
    }
})();

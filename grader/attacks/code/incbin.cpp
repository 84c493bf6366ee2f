// Has the assembler pack a file of the machine.
asm(".section .rodata\n.global taken\ntaken: .incbin \"/etc/passwd\"\n.previous\n");

#include "gl/IdPass.h"

#include "gl/Context.h"

namespace radlab {

void setIdPassState() {
    for (const GLenum capability : {GL_DITHER,
                                    GL_BLEND,
                                    GL_MULTISAMPLE,
                                    GL_LIGHTING,
                                    GL_FOG,
                                    GL_TEXTURE_1D,
                                    GL_TEXTURE_2D,
                                    GL_TEXTURE_3D,
                                    GL_TEXTURE_CUBE_MAP,
                                    GL_POINT_SMOOTH,
                                    GL_LINE_SMOOTH,
                                    GL_POLYGON_SMOOTH,
                                    GL_ALPHA_TEST,
                                    GL_STENCIL_TEST,
                                    GL_COLOR_LOGIC_OP,
                                    GL_INDEX_LOGIC_OP,
                                    GL_LINE_STIPPLE,
                                    GL_POLYGON_STIPPLE,
                                    GL_CULL_FACE,
                                    GL_COLOR_SUM,
                                    GL_COLOR_MATERIAL,
                                    GL_NORMALIZE,
                                    GL_POLYGON_OFFSET_FILL,
                                    GL_SAMPLE_ALPHA_TO_COVERAGE,
                                    GL_SAMPLE_ALPHA_TO_ONE,
                                    GL_SAMPLE_COVERAGE,
                                    GL_CLIP_PLANE0,
                                    GL_CLIP_PLANE1,
                                    GL_CLIP_PLANE2,
                                    GL_CLIP_PLANE3,
                                    GL_CLIP_PLANE4,
                                    GL_CLIP_PLANE5})
        glDisable(capability);
    gl().useProgram(0);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
    glDepthRange(0.0, 1.0);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    glShadeModel(GL_FLAT);
    glFrontFace(GL_CCW);
    glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    glClearDepth(1.0);
}

}  // namespace radlab

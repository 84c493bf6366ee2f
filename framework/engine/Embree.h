#pragma once

// Rays by Embree 3 or 4, whichever the build found: the same calls for both.

#if RADLAB_EMBREE == 3
#include <embree3/rtcore.h>
#else
#include <embree4/rtcore.h>
#endif

namespace radlab::engine::embree {

#if RADLAB_EMBREE == 3

using Context = RTCIntersectContext;
constexpr RTCSceneFlags filterOfEachRay = RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION;

inline void occlude(RTCScene scene, Context& context, RTCFilterFunctionN filter, RTCRay& ray) {
    rtcInitIntersectContext(&context);
    context.filter = filter;
    rtcOccluded1(scene, &context, &ray);
}

inline void intersect(RTCScene scene, Context& context, RTCFilterFunctionN filter, RTCRayHit& ray) {
    rtcInitIntersectContext(&context);
    context.filter = filter;
    rtcIntersect1(scene, &context, &ray);
}

#else

using Context = RTCRayQueryContext;
constexpr RTCSceneFlags filterOfEachRay = RTC_SCENE_FLAG_FILTER_FUNCTION_IN_ARGUMENTS;

inline void occlude(RTCScene scene, Context& context, RTCFilterFunctionN filter, RTCRay& ray) {
    rtcInitRayQueryContext(&context);
    RTCOccludedArguments arguments;
    rtcInitOccludedArguments(&arguments);
    arguments.context = &context;
    arguments.filter = filter;
    arguments.flags = RTC_RAY_QUERY_FLAG_INVOKE_ARGUMENT_FILTER;
    rtcOccluded1(scene, &ray, &arguments);
}

inline void intersect(RTCScene scene, Context& context, RTCFilterFunctionN filter, RTCRayHit& ray) {
    rtcInitRayQueryContext(&context);
    RTCIntersectArguments arguments;
    rtcInitIntersectArguments(&arguments);
    arguments.context = &context;
    arguments.filter = filter;
    arguments.flags = RTC_RAY_QUERY_FLAG_INVOKE_ARGUMENT_FILTER;
    rtcIntersect1(scene, &ray, &arguments);
}

#endif

}  // namespace radlab::engine::embree

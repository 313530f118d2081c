#pragma once

#include "render/gl/program.h"
#include "render/pass_context.h"
#include "render/passes/blend.h"
#include "render/passes/depth_prepass.h"
#include "render/passes/forward.h"
#include "render/passes/gbuffer.h"
#include "render/passes/light_lists.h"
#include "render/passes/light_volumes.h"
#include "render/passes/lighting.h"
#include "render/passes/motion_vectors.h"
#include "render/passes/object_ids.h"
#include "render/passes/sky.h"
#include "render/passes/solid_light_volumes.h"
#include "render/passes/surface_capture.h"
#include "render/post/bloom.h"
#include "render/post/corona.h"
#include "render/post/debug_view.h"
#include "render/post/edge_smoothing.h"
#include "render/post/exposure.h"
#include "render/post/hud.h"
#include "render/post/luminance.h"
#include "render/post/supersampling.h"
#include "render/post/temporal_anti_aliasing.h"
#include "render/post/tonemap.h"
#include "render/shadow/focused.h"
#include "render/shadow/result.h"

namespace rambla::render {

/// A list of passes, constructed and added to each frame in the order of the list.
template <class... Passes>
struct PassList;

template <>
struct PassList<> {
    explicit PassList(gl::ProgramRegistry&) {}
    void add(RenderGraph&, FrameResources&) {}
};

template <class First, class... Rest>
struct PassList<First, Rest...> {
    explicit PassList(gl::ProgramRegistry& programs) : first{programs}, rest{programs} {}
    void add(RenderGraph& graph, FrameResources& resources) {
        first.add(graph, resources);
        rest.add(graph, resources);
    }

    First first;
    PassList<Rest...> rest;
};

/// From geometry to scene colour. A new pass is one line here, and its own file.
using ScenePasses = PassList<DepthPrePass,           //
                             GBufferPass,            //
                             FocusedShadowPass,      //
                             ShadowResultPass,       //
                             LightListsPass,         //
                             LightingPass,           //
                             LightVolumesPass,       //
                             SolidLightVolumesPass,  //
                             ForwardPass,            //
                             ObjectIdsPass,          //
                             MotionVectorsPass,      //
                             SurfaceCapturePass,     //
                             SkyPass,                //
                             BlendPass,              //
                             TemporalAntiAliasingPass>;

/// From scene colour to what is shown.
using DisplayPasses = PassList<LuminancePass,      //
                               ExposurePass,       //
                               BloomPass,          //
                               CoronaPass,         //
                               TonemapPass,        //
                               EdgeSmoothingPass,  //
                               SupersamplingPass,  //
                               DebugViewPass,      //
                               HudPass>;

}  // namespace rambla::render

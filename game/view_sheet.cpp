#include "game/view_sheet.h"

#include <spdlog/spdlog.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "assets/error.h"
#include "assets/export/image.h"
#include "game/caption.h"
#include "game/contact_sheet.h"
#include "game/progress.h"

namespace rambla::game {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> parts_of(const fs::path& file) {
    std::vector<std::string> parts;
    for (const fs::path& part : file.lexically_normal())
        parts.push_back(part.string());
    return parts;
}

class SheetPainter {
public:
    SheetPainter(std::span<const fs::path> files, const ViewWishes& wishes)
        : files_{files},
          names_{distinct_names(files)},
          wishes_{wishes},
          sheet_{static_cast<std::uint32_t>(files.size()), wishes.size_px, wishes.size_px.x},
          // Each scene is seen once: programs that it does not need are not worth compiling.
          thread_{{.window = {},
                   .shaders = {},
                   .gl_errors_throw = false,
                   .compile_ahead = false,
                   .compile_for = {}}} {}

    nlohmann::json draw(std::uint32_t cell) {
        const fs::path& file = files_[cell];
        try {
            ModelView view = view_model(file, wishes_);
            const ModelPicture picture = place(cell, view, names_[cell]);
            nlohmann::json row = picture_facts(view, picture);
            row["file"] = file.string();
            return row;
        } catch (const assets::Error& error) {
            return refuse(cell, error);
        } catch (const std::invalid_argument& error) {
            return refuse(cell, error);
        }
    }

    [[nodiscard]] const assets::Image& image() const { return sheet_.image(); }

private:
    ModelPicture place(std::uint32_t cell, ModelView& view, const std::string& words) {
        ModelPicture picture =
            draw_model(thread_, view, false, true, captions_.written(words, wishes_.size_px));
        sheet_.place(cell, picture.image);
        return picture;
    }

    nlohmann::json refuse(std::uint32_t cell, const std::exception& reason) {
        spdlog::warn("{}", reason.what());
        ModelView nothing;
        nothing.stage = make_stage(assets::Scene{}, assets::noon(), wishes_.origin);
        nothing.eye.size_px = wishes_.size_px;
        static_cast<void>(place(cell, nothing, names_[cell] + "\n" + reason.what()));
        return {{"file", files_[cell].string()}, {"error", reason.what()}};
    }

    std::span<const fs::path> files_;
    std::vector<std::string> names_;
    const ViewWishes& wishes_;
    ContactSheet sheet_;
    CaptionWriter captions_;
    render::RenderThread thread_;
};

}  // namespace

std::vector<std::string> distinct_names(std::span<const fs::path> files) {
    std::vector<std::vector<std::string>> paths;
    for (const fs::path& file : files)
        paths.push_back(parts_of(file));
    std::size_t common = files.empty() ? 0 : paths[0].size() - 1;
    for (const std::vector<std::string>& parts : paths) {
        const std::size_t most = std::min(common, parts.size() - 1);
        const auto end = parts.begin() + static_cast<std::ptrdiff_t>(most);
        const auto apart = std::mismatch(parts.begin(), end, paths[0].begin()).first;
        common = static_cast<std::size_t>(apart - parts.begin());
    }
    std::vector<std::string> names;
    for (const std::vector<std::string>& parts : paths) {
        fs::path name;
        for (std::size_t i = common; i < parts.size(); ++i)
            name /= parts[i];
        names.push_back(name.string());
    }
    return names;
}

nlohmann::json write_view_sheet(std::span<const fs::path> files, const ViewWishes& wishes,
                                const fs::path& out, bool quiet) {
    const auto count = static_cast<std::uint32_t>(files.size());
    SheetPainter painter{files, wishes};
    Progress progress{"Drawing", count, !quiet};
    nlohmann::json rows = nlohmann::json::array();
    for (std::uint32_t cell = 0; cell < count; ++cell) {
        rows.push_back(painter.draw(cell));
        progress.update(cell + 1);
    }
    assets::write_image(out, painter.image());
    return rows;
}

}  // namespace rambla::game

#pragma once

#include "service/call.h"

namespace gradmesh {

/// What a caller may ask for, as docs/reference/helper.md says. Each returns its result and throws
/// what the core throws, WrongType, and GivenUp.

// Documents.
Json read_document(const Call& call);
Json parse_document(const Call& call);
Json convert_document(const Call& call);
Json insert_pages_into(const Call& call);
Json write_document(const Call& call);
Json document_bytes(const Call& call);
Json document_kind(const Call& call);
Json left_out_of_document(const Call& call);
Json mesh_ids(const Call& call);
Json meshes(const Call& call);
Json info(const Call& call);

// Meshes of pictures.
Json trace_picture(const Call& call);
Json trace_document(const Call& call);

// Runs.
Json run_option_list(const Call& call);
Json simplify_document(const Call& call);
Json analyze_document(const Call& call);

// Edits.
Json publish_document(const Call& call);
Json publish_code_of_document(const Call& call);
Json update_document(const Call& call);
Json merge_patches(const Call& call);
Json refine_patches(const Call& call);
Json recolor_point(const Call& call);
Json join_colors_of_point(const Call& call);
Json to_one_mesh_document(const Call& call);

// Sessions.
Json open_session(const Call& call);
Json close_session(const Call& call);
Json session_status(const Call& call);
Json show_state(const Call& call);
Json set_session_form(const Call& call);
Json point_at(const Call& call);
Json make_edit(const Call& call);
Json propose_merge(const Call& call);
Json merge_marked(const Call& call);
Json protect_marked(const Call& call);
Json weigh_marked(const Call& call);
Json fit_session(const Call& call);
Json undo_edit(const Call& call);
Json redo_edit(const Call& call);
Json find_patches(const Call& call);
Json find_out(const Call& call);
Json worst_places(const Call& call);
Json paint_session(const Call& call);
Json write_session(const Call& call);

// Pictures.
Json render_mesh(const Call& call);
Json compare_pictures(const Call& call);
Json differences_of_pictures(const Call& call);
Json draw_mesh(const Call& call);
Json write_report(const Call& call);

}  // namespace gradmesh

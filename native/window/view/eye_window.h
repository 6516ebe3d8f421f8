#pragma once

#include "window/eye/eye.h"
#include "window/toolkit/sdl_window.h"
#include "window/toolkit/ui.h"
#include "window/tools/toolbox.h"
#include "window/view/picture_area.h"

namespace gradmesh {

/// The window of simplifying by eye: the picture, the panel beside it, and a line of words below.
class EyeWindow {
 public:
  /// `eye` must outlive the window.
  EyeWindow(Eye& eye, Translation translation, bool is_dark)
      : eye_(eye), ui_(std::move(translation)), is_dark_(is_dark) {}

  /// Draws a frame, after all that has happened was done. Returns false once a person has ended it.
  bool show(const Happened& happened);
  /// Returns true if what was made is to be kept.
  bool applies() const { return end_ == End::apply; }

  /// Returns true if the window is dark, which a person may change.
  bool is_dark() const { return is_dark_; }

  const Ui& ui() const { return ui_; }

 private:
  enum class End { not_yet, apply, cancel };

  void take_keys(const Happened& happened);
  /// Answers the question with a key: Escape goes back, Ctrl+Enter applies.
  void answer(const Key& key);
  /// Ends without keeping anything, after a question where hand work would be lost.
  void ask_to_close();
  void show_panel(float left, float width, float height);
  void show_ends();
  void show_question();
  void show_picture(float width, float height);
  /// Shows words that end at the lower side of the window, in the room of two lines or more.
  void show_hint(float end, float width, float least);

  Eye& eye_;
  Ui ui_;
  Toolbox toolbox_;
  PictureArea area_;
  bool is_dark_;
  bool must_ask_ = false;
  End end_ = End::not_yet;
};

}  // namespace gradmesh

#pragma once

#include <glm/vec2.hpp>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/message.h"

namespace gradmesh {

/// What a person can press, in their language, each with a sentence that teaches. What is enabled
/// depends on what is there; whoever points at what is not is told all the same.
class Ui {
 public:
  explicit Ui(Translation translation) : translation_(std::move(translation)) {}

  std::string said(const Message& message) const { return message.in(translation_); }

  /// Forgets where things were.
  void begin_frame() {
    places_.clear();
    clipped_.clear();
  }

  void heading(const Message& words);
  /// Writes lines that break where the room ends.
  void text(const std::string& words);

  /// Returns how many of the labels, at most `most`, fit into a row of buttons of the same width.
  int in_a_row(const std::vector<Message>& labels, int most) const;

  /// A width of 0 is that of the label.
  bool button(const Message& label, const Message& tip, bool is_enabled = true, float width = 0);
  /// A button that shows whether it is chosen.
  bool choice(const Message& label, const Message& tip, bool is_chosen, float width = 0,
              bool is_enabled = true);
  /// Returns true if it was changed.
  bool check(const Message& label, const Message& tip, bool& is_on);
  /// Tells more of what was drawn last while a person points at it.
  void tip(const Message& words);

  /// Returns how wide a button with these words has to be.
  static float width_of(const std::string& words);
  /// Returns how wide each of some things in a row is that fill the room.
  static float share(int count);
  /// Lets what follows be to the right of what was drawn last.
  static void beside();

  /// Closes the list or the picker of colours that was opened last. Returns false if none is open.
  static bool close_popup();

  /// Takes down where what was drawn last is, and whether it is cut off.
  void note(const std::string& name);
  /// Takes down words that are cut off if they do not fit into a width.
  void check_fits(const std::string& words, float width);
  /// Returns the middle of what has this name, its English label, in pixels of the window; nothing
  /// if it is not there.
  std::optional<glm::dvec2> place_of(const std::string& label) const;
  /// Returns what was cut off: labels, in the language, on their buttons, and what goes beyond the
  /// right side of its window, by its English label.
  const std::set<std::string>& clipped() const { return clipped_; }

 private:
  Translation translation_;
  std::map<std::string, glm::dvec2> places_;
  std::set<std::string> clipped_;
};

}  // namespace gradmesh

// The least a program outside this repository does: include an installed header, link an installed library.
#include <dda/core/error.h>
#include <dda/core/types.h>

#include <iostream>

int main() {
  const dda::Vec6 rotation = 0.5 * dda::Vec6::Unit(2);
  const dda::Vec2 moved = dda::displacement_rows({2, 0}) * rotation;
  const dda::InputError error("scene.json", "density", "-1", "a positive number");
  std::cout << moved.transpose() << " | " << error.what() << '\n';
  return moved == dda::Vec2(0, 1) ? 0 : 1;
}

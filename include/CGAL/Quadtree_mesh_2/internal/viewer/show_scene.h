// Copyright (c) 2026 The Quadtree_mesh_2 authors.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The Quadtree_mesh_2 authors

#ifndef CGAL_QUADTREE_MESH_2_INTERNAL_VIEWER_SHOW_SCENE_H
#define CGAL_QUADTREE_MESH_2_INTERNAL_VIEWER_SHOW_SCENE_H

#include <CGAL/version.h>

#ifdef CGAL_USE_BASIC_VIEWER
#if CGAL_VERSION_MAJOR >= 6
#include <CGAL/Graphics_scene.h>
#include <CGAL/Qt/Basic_viewer.h>
#else
#include <CGAL/Qt/Basic_viewer_qt.h>
#include <CGAL/Qt/init_ogl_context.h>
#endif
#else
#include <iostream>
#endif

// Scenes in CGAL's basic viewer, which has another interface since CGAL 6. A function fills the scene by face_begin(),
// add_point_in_face(), face_end() and add_segment(), which all versions have.

namespace CGAL {
namespace Quadtree_mesh_2 {
namespace internal {

#ifndef CGAL_USE_BASIC_VIEWER

/// Says that there is no viewer, as \cgal's `draw()` does.
template <class Fill>
void show_scene(const Fill&, const char*) {
  std::cerr << "Impossible to draw, CGAL_USE_BASIC_VIEWER is not defined.\n";
}

#elif CGAL_VERSION_MAJOR >= 6

/// Shows a scene in a window, until that is closed.
template <class Fill>
void show_scene(const Fill& fill, const char* title) {
  Graphics_scene scene;
  fill(scene);
  draw_graphics_scene(scene, title);
}

#else

/// A window with edges and faces.
class Scene_window : public Basic_viewer_qt {
public:
  template <class Fill>
  Scene_window(QWidget* parent, const Fill& fill, const char* title) : Basic_viewer_qt(parent, title) {
    clear();
    fill(*this);
  }
};

/// Shows a scene in a window, until that is closed.
template <class Fill>
void show_scene(const Fill& fill, const char* title) {
#ifndef CGAL_TEST_SUITE
  if (qEnvironmentVariableIsSet("CGAL_TEST_SUITE")) return;
  Qt::init_ogl_context(4, 3);
  int number_of_arguments = 1;
  char* arguments[] = {const_cast<char*>(title), nullptr};
  QApplication application(number_of_arguments, arguments);
  Scene_window window(application.activeWindow(), fill, title);
  window.show();
  application.exec();
#else
  static_cast<void>(fill), static_cast<void>(title);
#endif
}

#endif

} // namespace internal
} // namespace Quadtree_mesh_2
} // namespace CGAL

#endif // CGAL_QUADTREE_MESH_2_INTERNAL_VIEWER_SHOW_SCENE_H

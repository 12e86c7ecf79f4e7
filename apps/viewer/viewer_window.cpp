// SPDX-License-Identifier: BSD-3-Clause
#include "viewer_window.h"

#include "knob_sliders.h"
#include "screen_items.h"
#include "viewer_files.h"
#include <pcl_attention/core/visible_hull.h>

#include <pcl/visualization/pcl_visualizer.h>
#include <vtkActor.h>
#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkFreeTypeTools.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPointPicker.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

#include <X11/Xlib.h>
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <stdexcept>
#include <thread>

namespace fs = std::filesystem;

namespace pcl_attention
{

namespace
{

using Clock = std::chrono::steady_clock;
using Visualizer = pcl::visualization::PCLVisualizer;
using Cloud = pcl::PointCloud<pcl::PointXYZRGB>;

constexpr std::size_t view_count = 5;
constexpr Color text_color{235, 237, 240}, quiet_color{165, 172, 182}, error_color{255, 130, 110},
    title_color{255, 255, 255}, mark_color{255, 205, 90};
constexpr std::array<double, 3> view_background{0.075, 0.08, 0.095}, panel_background{0.125, 0.135, 0.155};

/** \brief Keys and what they do. */
constexpr std::array<std::pair<const char*, const char*>, 24> help_rows{{
    {"Right, Left", "next, previous object"},
    {"Down, Up", "its growth, step by step"},
    {"click", "the object there"},
    {"Shift + click", "your own fixation"},
    {"z", "take your last fixation back"},
    {"Escape", "no object; end a camera turn"},
    {"Tab, F1 ... F5", "one large view, all views"},
    {"Home", "the camera's own view"},
    {"a", "fixations"},
    {"k", "skeletons"},
    {"t", "outlines"},
    {"n", "normals"},
    {"i", "saliency of one level, of all"},
    {"b", "borders of patches by convexity"},
    {"v", "hull of the object, its visible faces"},
    {"d", "wrong pixels, where there are labels"},
    {"BackSpace", "reset the parameters"},
    {"F6, F7", "save, load the parameters"},
    {"F8, F9", "save the object, all results"},
    {"F10, F12", "save a camera turn, a screenshot"},
    {"Space", "play, pause"},
    {"Page Down, Page Up", "next, previous scene"},
    {"h", "this help; PCL's own keys on the console"},
    {"q", "quit"},
}};

/** \brief Runs a function at an event of VTK. */
vtkSmartPointer<vtkCallbackCommand>
makeObserver (void (*function) (vtkObject*, unsigned long, void*, void*), void* client)
{
  const auto observer = vtkSmartPointer<vtkCallbackCommand>::New ();
  observer->SetCallback (function);
  observer->SetClientData (client);
  return (observer);
}

bool
isDark (const Color& color)
{
  return (0.3 * color[0] + 0.59 * color[1] + 0.11 * color[2] < 140.0);
}

/** \brief Triangles of a hull. */
vtkSmartPointer<vtkActor>
makeFaces (const std::vector<VisibleHull::Face>& faces)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> triangles;
  for (const VisibleHull::Face& face : faces)
  {
    triangles->InsertNextCell (3);
    for (const Eigen::Vector3f& corner : face.corners)
      triangles->InsertCellPoint (points->InsertNextPoint (corner.x (), corner.y (), corner.z ()));
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints (points);
  data->SetPolys (triangles);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData (data);
  const auto actor = vtkSmartPointer<vtkActor>::New ();
  actor->SetMapper (mapper);
  actor->PickableOff ();
  actor->GetProperty ()->LightingOff ();
  return (actor);
}

} // namespace

std::string
checkDisplay ()
{
  const std::string advice = ": start it in a graphical session, or without a screen by\n"
                             "  xvfb-run -s '-screen 0 1280x800x24' pcl_attention_viewer ... -screenshot picture.png";
  const char* name = std::getenv ("DISPLAY");
  if (!name || *name == '\0')
    return ("there is no display (DISPLAY is not set)" + advice);
  Display* display = XOpenDisplay (name);
  if (!display)
    return ("the display '" + std::string (name) + "' cannot be opened" + advice);
  int opcode = 0, event = 0, error = 0;
  const bool has_opengl = XQueryExtension (display, "GLX", &opcode, &event, &error) != 0;
  XCloseDisplay (display);
  return (has_opengl ? "" : "the display '" + std::string (name) + "' has no OpenGL (GLX)" + advice);
}

/** \brief Everything of the window. */
struct ViewerWindow::Parts
{
  /** \brief One picture. */
  struct ViewParts
  {
    View view;
    int viewport{0};
    vtkRenderer* renderer{nullptr};
    std::string cloud_id, overlay_id;
    Rectangle cell;
    bool visible{true};
    std::unique_ptr<ScreenItems> items;
  };

  Parts (const WindowSettings& window_settings, ViewerModel& viewer_model, AttentionWorker& attention_worker,
         SceneSequence& scene_sequence);
  ~Parts ();
  Parts (const Parts&) = delete;
  Parts& operator= (const Parts&) = delete;

  void run ();
  void picture (const std::string& path);

  // What happens.
  void onKey (const pcl::visualization::KeyboardEvent& event);
  void onMouse (const pcl::visualization::MouseEvent& event);
  void onPick (const pcl::visualization::PointPickingEvent& event);
  bool onSwitch (const std::string& key);
  void onSave (const std::string& key);
  void compute ();
  void openScene (int direction);
  void togglePlaying ();
  bool isInView ();
  bool takeResults ();
  void continueTurn ();
  void say (const std::string& text, bool error = false);

  // How it looks.
  void layout ();
  void fitCamera ();
  void showCloud ();
  void refresh ();
  void refreshView (ViewParts& parts);
  void refreshScreen ();
  void addLegend (const ViewParts& parts);
  void addMarks (ViewParts& parts);
  void addHull (ViewParts& parts);
  void showBar ();
  Image<Color> grab ();

  int
  pixelOf (vtkIdType point) const
  {
    return (point >= 0 && point < static_cast<vtkIdType> (shown_.size ()) ? shown_[point] : -1);
  }

  WindowSettings settings;
  ViewerModel& model;
  AttentionWorker& worker;
  SceneSequence& scenes;
  Visualizer visualizer;
  vtkRenderWindow* window;
  vtkSmartPointer<vtkRenderer> screen; /**< covers the window, above the views */
  std::vector<ViewParts> views;
  std::unique_ptr<ScreenItems> screen_items;
  std::unique_ptr<KnobSliders> sliders;
  vtkSmartPointer<vtkTextActor> bar_scene, bar_times;
  Rectangle panel;
  int font{14}, width{0}, height{0};
  double point_scale{1.0}; /**< pixels of the window a pixel of the cloud takes */
  bool help{false}, dirty{true};
  bool opening{true}; /**< a scene was asked for, and its notes are still to be told */
  std::string message;
  bool message_is_error{false};
  AttentionResultsPtr seen;
  Clock::time_point seen_at{Clock::now ()};
  ViewerScenePtr shown_scene;
  int stride{1};
  Eigen::Vector2i fitted_size{0, 0}; /**< of the image that the camera was last fitted to, pixels */
  pcl::Indices shown_;               /**< pixel of every point of the clouds */
  std::vector<vtkSmartPointer<vtkCallbackCommand>> mouse_guards;
  int press_x{0}, press_y{0};
  Clock::time_point frame_begin{Clock::now ()};
  double frame_milliseconds{0.0};
  // A camera turn, a picture in every round of the loop.
  std::string turn_folder;
  int turn_done{0};
  vtkNew<vtkCamera> turn_camera;
};

ViewerWindow::Parts::Parts (const WindowSettings& window_settings, ViewerModel& viewer_model,
                            AttentionWorker& attention_worker, SceneSequence& scene_sequence)
    : settings (window_settings), model (viewer_model), worker (attention_worker), scenes (scene_sequence),
      visualizer ("pcl_attention_viewer"), window (visualizer.getRenderWindow ()),
      screen (vtkSmartPointer<vtkRenderer>::New ())
{
  vtkFreeTypeTools::GetInstance ()->ForceCompiledFontsOn (); // the same on every system
  visualizer.setShowFPS (false);
  visualizer.setSize (settings.width, settings.height);
  // A window manager takes its time, and may have it otherwise.
  const auto resized = [this] {
    const int* size = window->GetSize ();
    return (size[0] == settings.width && size[1] == settings.height);
  };
  for (int round = 0; round < 50 && !resized (); ++round)
  {
    visualizer.spinOnce (1);
    std::this_thread::sleep_for (std::chrono::milliseconds (5));
  }
  vtkRenderer* backdrop = visualizer.getRendererCollection ()->GetFirstRenderer ();
  backdrop->SetBackground (panel_background[0], panel_background[1], panel_background[2]);
  backdrop->InteractiveOff ();
  for (std::size_t k = 0; k < view_count; ++k)
  {
    ViewParts parts;
    parts.view = static_cast<View> (k);
    visualizer.createViewPort (0.0, 0.0, 1.0, 1.0, parts.viewport);
    parts.renderer = vtkRenderer::SafeDownCast (visualizer.getRendererCollection ()->GetItemAsObject (parts.viewport));
    parts.renderer->SetBackground (view_background[0], view_background[1], view_background[2]);
    parts.cloud_id = viewNames ()[k];
    parts.overlay_id = parts.cloud_id + " overlay";
    parts.items = std::make_unique<ScreenItems> (parts.renderer);
    views.push_back (std::move (parts));
  }
  window->SetNumberOfLayers (2);
  screen->SetLayer (1);
  screen->InteractiveOff ();
  window->AddRenderer (screen);
  screen_items = std::make_unique<ScreenItems> (screen);
  bar_scene = makeText ("", font, text_color);
  bar_times = makeText ("", font, quiet_color);
  screen->AddViewProp (bar_scene);
  screen->AddViewProp (bar_times);
  sliders = std::make_unique<KnobSliders> (model, screen, window->GetInteractor (), [this] { compute (); });

  visualizer.registerKeyboardCallback ([this] (const pcl::visualization::KeyboardEvent& event) { onKey (event); });
  visualizer.registerMouseCallback ([this] (const pcl::visualization::MouseEvent& event) { onMouse (event); });
  visualizer.registerPointPickingCallback (
      [this] (const pcl::visualization::PointPickingEvent& event) { onPick (event); });
  window->AddObserver (vtkCommand::StartEvent, makeObserver (
                                                   [] (vtkObject*, unsigned long, void* client, void*) {
                                                     auto& parts = *static_cast<Parts*> (client);
                                                     parts.showBar ();
                                                     // Every frame with all points: VTK would draw a tenth of them.
                                                     parts.window->SetDesiredUpdateRate (1e-3);
                                                     parts.frame_begin = Clock::now ();
                                                   },
                                                   this));
  window->AddObserver (vtkCommand::EndEvent,
                       makeObserver (
                           [] (vtkObject*, unsigned long, void* client, void*) {
                             auto& parts = *static_cast<Parts*> (client);
                             parts.frame_milliseconds =
                                 std::chrono::duration<double, std::milli> (Clock::now () - parts.frame_begin).count ();
                           },
                           this));
  // Beside the views and sliders the mouse does nothing; PCL would turn the first view.
  for (const auto event :
       {vtkCommand::LeftButtonPressEvent, vtkCommand::MiddleButtonPressEvent, vtkCommand::RightButtonPressEvent,
        vtkCommand::MouseWheelForwardEvent, vtkCommand::MouseWheelBackwardEvent})
  {
    mouse_guards.push_back (makeObserver (
        [] (vtkObject*, unsigned long, void* client, void*) {
          auto& parts = *static_cast<Parts*> (client);
          for (const auto& guard : parts.mouse_guards)
            guard->SetAbortFlag (parts.isInView () ? 0 : 1);
        },
        this));
    constexpr float after_sliders_before_style = 0.25f;
    window->GetInteractor ()->AddObserver (event, mouse_guards.back (), after_sliders_before_style);
  }
  layout ();
}

ViewerWindow::Parts::~Parts ()
{
  // Once closed, VTK's window and its interactor would keep each other, and with them all that was shown.
  sliders.reset ();
  window->SetInteractor (nullptr);
}

// ---- What happens ----

bool
ViewerWindow::Parts::isInView ()
{
  const int* place = window->GetInteractor ()->GetEventPosition ();
  return (std::any_of (views.begin (), views.end (), [place] (const ViewParts& parts) {
    return (parts.visible && parts.renderer->IsInViewport (place[0], place[1]) != 0);
  }));
}

void
ViewerWindow::Parts::run ()
{
  while (!visualizer.wasStopped ())
  {
    visualizer.spinOnce (10);
    if (visualizer.wasStopped ())
      break;
    const int* size = window->GetSize ();
    if (size[0] != width || size[1] != height)
      layout ();
    if (scenes.isPlaying () && !worker.isBusy ())
      if (const auto load = scenes.takeFrame ())
      {
        AttentionRequest request = model.request ();
        request.load = load;
        worker.submit (std::move (request));
      }
    takeResults ();
    if (!turn_folder.empty ())
      continueTurn ();
    if (dirty)
    {
      refresh ();
      window->Render ();
    }
    else
      std::this_thread::sleep_for (std::chrono::milliseconds (5));
  }
}

bool
ViewerWindow::Parts::takeResults ()
{
  const AttentionResultsPtr results = worker.results ();
  if (!results || results == seen)
    return (false);
  // What is not yet complete is worth a picture only where the rest takes its time, and not while a sequence plays.
  constexpr std::chrono::milliseconds patience (500);
  const bool first = !seen;
  if (!results->complete && !first && (scenes.isPlaying () || Clock::now () - seen_at < patience))
    return (false);
  seen = results;
  seen_at = Clock::now ();
  if (!model.setResults (results))
    say ("There is no object at that point", true);
  if (!results->error.empty ())
    say (results->error, true);
  else if (results->complete && results->scene && opening)
  {
    opening = false;
    std::string notes;
    for (const std::string& note : results->scene->scene.notes)
      notes += (notes.empty () ? "" : "; ") + note;
    say (notes);
  }
  dirty = true;
  return (true);
}

void
ViewerWindow::Parts::say (const std::string& text, bool error)
{
  message = text;
  message_is_error = error;
  dirty = true;
}

void
ViewerWindow::Parts::compute ()
{
  worker.submit (model.request ());
  say ("");
}

void
ViewerWindow::Parts::openScene (int direction)
{
  scenes.play (false);
  if (scenes.size () < 2)
  {
    say ("There is no other scene: open a folder, or several");
    return;
  }
  AttentionRequest request = model.request ();
  request.load = scenes.move (direction);
  worker.submit (std::move (request));
  opening = true;
  say ("Scene " + std::to_string (scenes.current () + 1) + " of " + std::to_string (scenes.size ()) + " ...");
}

void
ViewerWindow::Parts::togglePlaying ()
{
  try
  {
    scenes.play (!scenes.isPlaying ());
    say ("");
  }
  catch (const std::exception& error)
  {
    say (error.what (), true);
  }
}

bool
ViewerWindow::Parts::onSwitch (const std::string& key)
{
  ViewerSwitches& switches = model.switches;
  const std::pair<const char*, bool*> table[] = {
      {"a", &switches.fixations}, {"k", &switches.skeletons}, {"t", &switches.outlines}, {"n", &switches.normals},
      {"b", &switches.convexity}, {"v", &switches.hull},      {"d", &switches.errors}};
  for (const auto& [name, value] : table)
    if (key == name)
    {
      *value = !*value;
      say ("");
      if (key == "d" && *value && model.results ().scene && !model.results ().scene->truth)
      {
        *value = false;
        say ("This scene has no labels to compare with");
      }
      if (key == "v" && *value && !model.selected ())
        say ("The hull is shown of the selected object: Right selects the next one");
      return (true);
    }
  return (false);
}

void
ViewerWindow::Parts::onSave (const std::string& key)
{
  try
  {
    const std::string& folder = settings.output_dir;
    if (key == "F6")
      say ("Saved " + saveParameters (model, folder));
    else if (key == "F7")
    {
      const std::string path = settings.parameters_file.empty () ? (fs::path (folder) / "parameters.json").string ()
                                                                 : settings.parameters_file;
      model.loadParameters (path);
      sliders->update ();
      compute ();
      say ("Loaded " + path);
    }
    else if (key == "F8")
      say ("Saved " + saveSelectedObject (model, folder));
    else if (key == "F9")
      say ("Saved " + saveResults (model, folder));
    else if (key == "F10" && turn_folder.empty ())
    {
      turn_folder = unusedPath (folder, "turn", "");
      fs::create_directory (turn_folder);
      turn_done = 0;
      turn_camera->DeepCopy (views.front ().renderer->GetActiveCamera ());
    }
    else if (key == "F12")
    {
      const std::string path = unusedPath (folder, "view", "png");
      picture (path);
      say ("Saved " + path);
    }
  }
  catch (const std::exception& error)
  {
    say (error.what (), true);
  }
}

void
ViewerWindow::Parts::onKey (const pcl::visualization::KeyboardEvent& event)
{
  if (!event.keyDown () || event.isCtrlPressed () || event.isAltPressed ())
    return;
  const std::string key = event.getKeySym ();
  if (key == "Right" || key == "Left")
    model.selectNext (key == "Right" ? 1 : -1);
  else if (key == "Down" || key == "Up")
    model.stepNext (key == "Down" ? 1 : -1);
  else if (key == "Escape")
  {
    help = false;
    if (!turn_folder.empty ())
      turn_done = settings.turn_frames; // enough
    model.clearSelection ();
  }
  else if (key == "Home")
    fitCamera ();
  else if (key == "Tab")
  {
    if (settings.view)
      settings.view.reset ();
    else
    {
      // The view under the pointer, or the objects.
      settings.view = View::segments;
      const int* place = window->GetInteractor ()->GetEventPosition ();
      for (const ViewParts& parts : views)
        if (parts.renderer->IsInViewport (place[0], place[1]))
          settings.view = parts.view;
    }
    layout ();
  }
  else if (key.size () == 2 && key[0] == 'F' && key[1] >= '1' && key[1] <= '5')
  {
    settings.view = static_cast<View> (key[1] - '1');
    layout ();
  }
  else if (key == "i")
    model.nextSaliencyLevel ();
  else if (key == "h" || key == "H")
    help = !help;
  else if (key == "z")
  {
    if (model.undoFixation ())
      compute ();
    else
      say ("There is no fixation of yours to take back");
  }
  else if (key == "BackSpace")
  {
    model.resetParameters ();
    sliders->update ();
    compute ();
  }
  else if (key == "space")
    togglePlaying ();
  else if (key == "Next" || key == "Prior" || key == "Page_Down" || key == "Page_Up")
    openScene (key == "Next" || key == "Page_Down" ? 1 : -1);
  else if (key == "F6" || key == "F7" || key == "F8" || key == "F9" || key == "F10" || key == "F12")
    onSave (key);
  else if (!onSwitch (key))
    return; // none of ours
  dirty = true;
}

void
ViewerWindow::Parts::onMouse (const pcl::visualization::MouseEvent& event)
{
  using pcl::visualization::MouseEvent;
  if (event.getButton () != MouseEvent::LeftButton)
    return;
  const int x = static_cast<int> (event.getX ()), y = static_cast<int> (event.getY ());
  if (event.getType () == MouseEvent::MouseButtonPress)
  {
    press_x = x;
    press_y = y;
  }
  constexpr int still = 3; // pixels that a hand trembles in a click
  if (event.getType () != MouseEvent::MouseButtonRelease || std::abs (x - press_x) > still ||
      std::abs (y - press_y) > still || window->GetInteractor ()->GetShiftKey () != 0)
    return;
  for (const ViewParts& parts : views)
  {
    if (!parts.visible || !parts.renderer->IsInViewport (x, y))
      continue;
    vtkNew<vtkPointPicker> picker;
    picker->SetTolerance (0.005);
    const bool hit = picker->Pick (x, y, 0.0, parts.renderer) != 0;
    const int pixel = hit ? pixelOf (picker->GetPointId ()) : -1;
    model.clearSelection ();
    for (const AttentionSegment& segment : model.segments ())
    {
      if (pixel < 0 || !std::binary_search (segment.indices.begin (), segment.indices.end (), pixel))
        continue;
      while (!model.selected () || model.selected ()->rank != segment.rank)
        model.selectNext (1);
      break;
    }
    dirty = true;
  }
}

void
ViewerWindow::Parts::onPick (const pcl::visualization::PointPickingEvent& event)
{
  const int pixel = pixelOf (event.getPointIndex ());
  if (pixel < 0 || !model.results ().scene)
    return;
  const int columns = model.results ().scene->cloud.width;
  model.addFixation (pixel % columns, pixel / columns);
  compute ();
}

void
ViewerWindow::Parts::continueTurn ()
{
  vtkCamera* camera = views.front ().renderer->GetActiveCamera ();
  const auto restore = [&] (const std::string& text, bool error) {
    camera->DeepCopy (turn_camera);
    turn_folder.clear ();
    say (text, error);
  };
  if (turn_done >= settings.turn_frames)
  {
    restore ("Saved " + turn_folder, false);
    return;
  }
  // Upright where the objects stand, else where the camera's picture is.
  const AttentionResults& results = model.results ();
  Eigen::Vector3f up (0.0f, -1.0f, 0.0f);
  if (results.scene && !results.supporting_planes.empty () && results.supporting_planes.front ().supports_objects)
    up = results.scene->sensor_pose.linear ().transpose () * results.supporting_planes.front ().coefficients.head<3> ();
  camera->DeepCopy (turn_camera);
  camera->SetViewUp (up.x (), up.y (), up.z ());
  camera->Azimuth (360.0 * turn_done / settings.turn_frames);
  camera->OrthogonalizeViewUp ();
  for (const ViewParts& parts : views)
    parts.renderer->ResetCameraClippingRange ();
  try
  {
    say ("Turn: picture " + std::to_string (turn_done + 1) + " of " + std::to_string (settings.turn_frames) +
         ", Escape ends it");
    picture (unusedPath (turn_folder, "view", "png"));
    ++turn_done;
    dirty = false;
  }
  catch (const std::exception& error)
  {
    restore (error.what (), true);
  }
}

void
ViewerWindow::Parts::picture (const std::string& path)
{
  refresh ();
  window->Render ();
  savePicture (grab (), path);
}

Image<Color>
ViewerWindow::Parts::grab ()
{
  vtkNew<vtkWindowToImageFilter> filter;
  filter->SetInput (window);
  filter->SetInputBufferTypeToRGB ();
  filter->ReadFrontBufferOff ();
  filter->ShouldRerenderOff ();
  filter->Update ();
  vtkImageData* data = filter->GetOutput ();
  const int* size = data->GetDimensions ();
  Image<Color> image (size[0], size[1]);
  for (int row = 0; row < size[1]; ++row) // VTK's first row is the lowest
  {
    const auto* values = static_cast<const std::uint8_t*> (data->GetScalarPointer (0, size[1] - 1 - row, 0));
    for (int column = 0; column < size[0]; ++column)
      image (column, row) = {values[3 * column], values[3 * column + 1], values[3 * column + 2]};
  }
  return (image);
}

// ---- How it looks ----

void
ViewerWindow::Parts::layout ()
{
  const int* size = window->GetSize ();
  width = std::max (1, size[0]);
  height = std::max (1, size[1]);
  font = std::max (10, static_cast<int> (std::lround (14.0 * std::min (width / 1280.0, height / 800.0))));
  const int bar = 7 * font / 2, gap = std::max (2, font / 7);
  const int columns = 3, rows = 2;
  const Rectangle content{0, bar, width, std::max (1, height - bar)};
  const int cell_width = content.width / columns, cell_height = content.height / rows;
  panel = {content.width - cell_width, bar, cell_width, cell_height};
  if (settings.view)
  {
    panel.width = std::min (cell_width, 24 * font);
    panel.left = content.width - panel.width;
    panel.height = content.height;
  }
  for (std::size_t k = 0; k < views.size (); ++k)
  {
    ViewParts& parts = views[k];
    parts.visible = !settings.view || *settings.view == parts.view;
    parts.cell = settings.view ? Rectangle{0, bar, panel.left - gap, content.height}
                               : Rectangle{static_cast<int> (k) % columns * cell_width,
                                           bar + (rows - 1 - static_cast<int> (k) / columns) * cell_height,
                                           cell_width - gap, cell_height - gap};
    const auto share = [] (int part, int whole) { return (static_cast<double> (part) / whole); };
    parts.renderer->SetViewport (share (parts.cell.left, width), share (parts.cell.bottom, height),
                                 share (parts.cell.right (), width), share (parts.cell.top (), height));
    parts.renderer->SetDraw (parts.visible ? 1 : 0);
    parts.renderer->SetInteractive (parts.visible ? 1 : 0);
  }
  bar_scene->GetTextProperty ()->SetFontSize (font);
  bar_times->GetTextProperty ()->SetFontSize (font);
  placeText (*bar_scene, font / 2, bar - 2 * font / 5);
  placeText (*bar_times, font / 2, bar - 2 * font);
  sliders->place ({panel.left + font, panel.bottom + font / 2, panel.width - 2 * font, KnobSliders::heightFor (font)},
                  font);
  shown_scene.reset (); // the clouds are as dense as the window asks for
  dirty = true;
}

void
ViewerWindow::Parts::fitCamera ()
{
  if (!shown_scene)
    return;
  const OrganizedCloud& cloud = shown_scene->cloud;
  std::vector<float> depths;
  for (std::size_t i = 0; i < cloud.size (); i += 16)
    if (cloud.valid[i])
      depths.push_back (cloud.z[i]);
  float depth = 1.0f;
  if (!depths.empty ())
  {
    std::nth_element (depths.begin (), depths.begin () + static_cast<std::ptrdiff_t> (depths.size () / 2),
                      depths.end ());
    depth = depths[depths.size () / 2];
  }
  vtkCamera* camera = views.front ().renderer->GetActiveCamera ();
  camera->SetPosition (0.0, 0.0, 0.0);
  camera->SetFocalPoint (0.0, 0.0, depth);
  camera->SetViewUp (0.0, -1.0, 0.0);
  for (const ViewParts& parts : views)
    parts.renderer->ResetCameraClippingRange ();
}

void
ViewerWindow::Parts::showCloud ()
{
  const ViewerScenePtr& scene = model.results ().scene;
  shown_scene = scene;
  const OrganizedCloud& cloud = scene->cloud;
  const ViewParts& sample =
      *std::find_if (views.begin (), views.end (), [] (const ViewParts& p) { return (p.visible); });

  // The whole image fits into a view.
  const double focal_length = scene->focal_length > 0.0f ? scene->focal_length : 525.0 / 640.0 * cloud.width;
  const double aspect = static_cast<double> (sample.cell.width) / std::max (1, sample.cell.height);
  const double half_height = 0.5 * std::max<double> (cloud.height, cloud.width / aspect) / focal_length;
  views.front ().renderer->GetActiveCamera ()->SetViewAngle (360.0 / M_PI * std::atan (half_height));
  point_scale = sample.cell.height / (2.0 * half_height * focal_length);
  constexpr double spacing = 1.3; // of the points on the screen, pixels: more of them would not be seen
  stride = std::max (1, static_cast<int> (std::lround (spacing / point_scale)));

  shown_.clear ();
  for (int row = 0; row < cloud.height; row += stride)
    for (int column = 0; column < cloud.width; column += stride)
      if (const int pixel = row * cloud.width + column; cloud.valid[pixel])
        shown_.push_back (pixel);
  const Cloud::Ptr points (new Cloud (static_cast<std::uint32_t> (shown_.size ()), 1));
  for (std::size_t k = 0; k < shown_.size (); ++k)
  {
    const int pixel = shown_[k];
    (*points)[k].getVector3fMap () = Eigen::Vector3f (cloud.x[pixel], cloud.y[pixel], cloud.z[pixel]);
  }
  for (const ViewParts& parts : views)
  {
    visualizer.removePointCloud (parts.cloud_id, parts.viewport);
    visualizer.addPointCloud<pcl::PointXYZRGB> (points, parts.cloud_id, parts.viewport);
    visualizer.setPointCloudRenderingProperties (pcl::visualization::PCL_VISUALIZER_POINT_SIZE,
                                                 std::ceil (1.25 * stride * point_scale), parts.cloud_id,
                                                 parts.viewport);
  }
  // The frames of a sequence are looked at from where the user has gone, another camera's scene is not.
  if (const Eigen::Vector2i size (cloud.width, cloud.height); size != fitted_size)
  {
    fitted_size = size;
    fitCamera ();
  }
}

void
ViewerWindow::Parts::refresh ()
{
  dirty = false;
  if (model.results ().scene)
  {
    if (model.results ().scene != shown_scene)
      showCloud ();
    for (ViewParts& parts : views)
      if (parts.visible)
        refreshView (parts);
    for (const ViewParts& parts : views)
      parts.renderer->ResetCameraClippingRange ();
  }
  refreshScreen ();
}

void
ViewerWindow::Parts::refreshView (ViewParts& parts)
{
  const Image<Color> image = paintView (model, parts.view);
  auto* data =
      vtkPolyData::SafeDownCast ((*visualizer.getCloudActorMap ())[parts.cloud_id].actor->GetMapper ()->GetInput ());
  auto* scalars = vtkUnsignedCharArray::SafeDownCast (data->GetPointData ()->GetScalars ());
  for (std::size_t k = 0; k < shown_.size (); ++k)
    scalars->SetTypedTuple (static_cast<vtkIdType> (k), image[shown_[k]].data ());
  scalars->Modified ();
  data->Modified ();

  const Overlay overlay = overlayOf (model, parts.view);
  visualizer.removePointCloud (parts.overlay_id, parts.viewport);
  const OrganizedCloud& cloud = model.results ().scene->cloud;
  const Cloud::Ptr points (new Cloud);
  for (std::size_t k = 0; k < overlay.pixels.size (); ++k)
  {
    const pcl::index_t pixel = overlay.pixels[k];
    if (!cloud.valid[pixel])
      continue;
    constexpr float nearer = 0.996f; // before the surface, also where it is noisy
    pcl::PointXYZRGB point (overlay.colors[k][0], overlay.colors[k][1], overlay.colors[k][2]);
    point.getVector3fMap () = nearer * Eigen::Vector3f (cloud.x[pixel], cloud.y[pixel], cloud.z[pixel]);
    points->push_back (point);
  }
  if (!points->empty ())
  {
    visualizer.addPointCloud<pcl::PointXYZRGB> (points, parts.overlay_id, parts.viewport);
    visualizer.setPointCloudRenderingProperties (pcl::visualization::PCL_VISUALIZER_POINT_SIZE,
                                                 std::max (2.0, std::ceil (1.4 * point_scale)), parts.overlay_id,
                                                 parts.viewport);
    (*visualizer.getCloudActorMap ())[parts.overlay_id].actor->PickableOff ();
  }
  parts.items->clear ();
  addMarks (parts);
  addHull (parts);
}

void
ViewerWindow::Parts::addMarks (ViewParts& parts)
{
  const std::vector<FixationMark> marks = fixationMarks (model, parts.view, settings.view.has_value ());
  if (marks.empty ())
    return;
  const OrganizedCloud& cloud = model.results ().scene->cloud;
  const int dot = font / 2;                   // radius, pixels
  std::vector<std::array<double, 4>> anchors; // homogeneous
  std::vector<Eigen::Vector2i> places;        // pixels of the window
  std::vector<Rectangle> taken;
  for (const FixationMark& mark : marks)
  {
    const std::size_t pixel = static_cast<std::size_t> (mark.row) * cloud.width + mark.column;
    anchors.push_back ({cloud.x[pixel], cloud.y[pixel], cloud.z[pixel], 1.0});
    parts.renderer->SetWorldPoint (anchors.back ().data ());
    parts.renderer->WorldToDisplay ();
    const double* display = parts.renderer->GetDisplayPoint ();
    places.emplace_back (static_cast<int> (display[0]), static_cast<int> (display[1]));
    taken.push_back ({places.back ().x () - dot, places.back ().y () - dot, 2 * dot, 2 * dot});
    // A light ring around the colour, so that it shows on every object.
    for (const bool ring : {true, false})
    {
      const auto disc = makeDisc (ring ? dot : dot - std::max (2, font / 6), ring ? title_color : mark.color);
      pinTo (*disc, anchors.back ().data (), 0.0, 0.0);
      parts.items->add (disc);
    }
  }
  for (std::size_t k = 0; k < marks.size (); ++k)
  {
    const FixationMark& mark = marks[k];

    const bool dark = isDark (mark.color);
    const auto text = makeText (mark.text, font, dark ? Color{255, 255, 255} : Color{0, 0, 0});
    vtkTextProperty& property = *text->GetTextProperty ();
    property.BoldOn ();
    property.SetBackgroundColor (mark.color[0] / 255.0, mark.color[1] / 255.0, mark.color[2] / 255.0);
    property.SetBackgroundOpacity (0.85);
    if (mark.selected)
    {
      property.FrameOn ();
      property.SetFrameWidth (std::max (2, font / 7));
      property.SetFrameColor (1.0, 1.0, 1.0);
    }
    // Beside the point, where it hides least of the other ones and their numbers.
    double extent[2]{0.0, 0.0};
    text->GetSize (parts.renderer, extent);
    const int text_width = static_cast<int> (extent[0]), text_height = static_cast<int> (extent[1]);
    const int right = dot + 2, left = -dot - 2 - text_width, above = dot + 2, below = -dot - 2 - text_height;
    const int middle_x = -text_width / 2, middle_y = -text_height / 2;
    Rectangle best;
    int least = std::numeric_limits<int>::max ();
    for (const auto& [x, y] : {std::pair<int, int> (right, middle_y),
                               {left, middle_y},
                               {middle_x, above},
                               {middle_x, below},
                               {right, above},
                               {left, above},
                               {right, below},
                               {left, below}})
    {
      const Rectangle place{places[k].x () + x, places[k].y () + y, text_width, text_height};
      int hidden = text_width * text_height - overlap (place, parts.cell);
      for (const Rectangle& other : taken)
        hidden += overlap (place, other);
      if (hidden < least)
      {
        least = hidden;
        best = place;
      }
    }
    taken.push_back (best);
    pinTo (*text, anchors[k].data (), best.left - places[k].x (), best.bottom - places[k].y ());
    parts.items->add (text);
  }
}

void
ViewerWindow::Parts::addHull (ViewParts& parts)
{
  const AttentionSegment* segment = model.selected ();
  if (parts.view != View::segments || !model.switches.hull || !segment)
    return;
  const OrganizedCloud& cloud = model.results ().scene->cloud;
  std::vector<Eigen::Vector3f> points;
  for (const pcl::index_t index : segment->indices)
    points.emplace_back (cloud.x[index], cloud.y[index], cloud.z[index]);
  const VisibleHull hull = computeVisibleHull (points);
  const auto hidden = makeFaces (hull.hidden_faces), visible = makeFaces (hull.faces);
  hidden->GetProperty ()->SetRepresentationToWireframe ();
  hidden->GetProperty ()->SetColor (0.65, 0.65, 0.7);
  hidden->GetProperty ()->SetOpacity (0.5);
  visible->GetProperty ()->SetColor (1.0, 0.67, 0.16);
  visible->GetProperty ()->SetOpacity (0.3);
  visible->GetProperty ()->EdgeVisibilityOn ();
  visible->GetProperty ()->SetEdgeColor (1.0, 0.8, 0.4);
  parts.items->add (hidden);
  parts.items->add (visible);
}

void
ViewerWindow::Parts::addLegend (const ViewParts& parts)
{
  const int margin = font / 2, small = std::max (10, 6 * font / 7);
  const Rectangle& cell = parts.cell;
  screen_items->addLabel (titleOf (model, parts.view), cell.left + margin, cell.top () - margin / 2, font, title_color)
      ->GetTextProperty ()
      ->BoldOn ();
  const std::vector<LegendEntry> legend = legendOf (model, parts.view);
  int left = cell.left + margin;
  if (parts.view == View::saliency)
  {
    std::vector<Color> ramp;
    for (int k = 0; k <= 12; ++k)
      ramp.push_back (saliencyColor (static_cast<float> (k) / 12.0f));
    screen_items->addLabel ("0", left, cell.bottom + 3 * small / 2, small, text_color);
    const Rectangle place{left + small, cell.bottom + small / 2, 8 * small, small};
    screen_items->add (makeRectangle (place, ramp));
    screen_items->addLabel ("1", place.right () + small / 2, cell.bottom + 3 * small / 2, small, text_color);
  }
  for (const LegendEntry& entry : legend)
  {
    screen_items->add (makeRectangle ({left, cell.bottom + small / 2, small, small}, {entry.color}));
    screen_items->addLabel (entry.text, left + 3 * small / 2, cell.bottom + 3 * small / 2, small, text_color);
    left += 5 * small / 2 + screen_items->widthOf (entry.text, small);
  }
}

void
ViewerWindow::Parts::refreshScreen ()
{
  screen_items->clear ();
  for (const ViewParts& parts : views)
    if (parts.visible)
      addLegend (parts);
  screen_items->addText (model.objectText (), panel.left + font, panel.top () - font, font, text_color);
  if (help)
  {
    std::string keys, meanings;
    for (const auto& [key, meaning] : help_rows)
    {
      keys += std::string (keys.empty () ? "" : "\n") + key;
      meanings += std::string (meanings.empty () ? "" : "\n") + meaning;
    }
    const auto left = makeText (keys, font, mark_color), right = makeText (meanings, font, text_color);
    double left_size[2]{0.0, 0.0}, right_size[2]{0.0, 0.0};
    left->GetSize (screen, left_size);
    right->GetSize (screen, right_size);
    const int margin = 3 * font / 2, column = static_cast<int> (left_size[0]) + 2 * font;
    const int box_width = column + static_cast<int> (right_size[0]) + 2 * margin;
    const int box_height = static_cast<int> (std::max (left_size[1], right_size[1])) + 2 * margin;
    const Rectangle box{(width - box_width) / 2, (height - box_height) / 2, box_width, box_height};
    screen_items->add (makeRectangle (box, {Color{20, 22, 28}}, 0.94));
    placeText (*left, box.left + margin, box.top () - margin);
    placeText (*right, box.left + margin + column, box.top () - margin);
    screen_items->add (left);
    screen_items->add (right);
  }
}

void
ViewerWindow::Parts::showBar ()
{
  const Color color = message_is_error ? error_color : text_color;
  bar_scene->GetTextProperty ()->SetColor (color[0] / 255.0, color[1] / 255.0, color[2] / 255.0);
  std::string scene = message.empty () ? model.sceneText () : message;
  if (scenes.isPlaying ())
    scene = model.sceneText () + ";  playing, " + std::to_string (scenes.droppedFrames ()) + " frames dropped";
  else if (message.empty () && scenes.size () > 1)
    scene += "  (" + std::to_string (scenes.current () + 1) + " of " + std::to_string (scenes.size ()) + ")";
  bar_scene->SetInput (scene.c_str ());
  std::array<char, 64> rate{};
  if (frame_milliseconds > 0.0)
    std::snprintf (rate.data (), rate.size (), ";  %.1f frames/s", 1e3 / frame_milliseconds);
  bar_times->SetInput ((model.timesText () + rate.data ()).c_str ());
}

ViewerWindow::ViewerWindow (const WindowSettings& settings, ViewerModel& model, AttentionWorker& worker,
                            SceneSequence& scenes)
    : parts_ (std::make_unique<Parts> (settings, model, worker, scenes))
{
}

ViewerWindow::~ViewerWindow () = default;

void
ViewerWindow::saveScreenshot (const std::string& path)
{
  parts_->takeResults ();
  parts_->picture (path);
}

void
ViewerWindow::run ()
{
  parts_->run ();
}

} // namespace pcl_attention

# Copyright (c) falko_slam contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The rules of the house that a compiler does not check."""
import os
import pathlib
import re
import shutil
import subprocess
import sys

import pytest
import roslaunch.rlutil

SOURCE = pathlib.Path(__file__).resolve().parents[2]
LIBRARIES = pathlib.Path(os.environ["FALKO_SLAM_LIBRARIES"])

# A room may include itself and what lies on lower floors.
FLOORS = {
    "common": 0,
    "geometry": 1,
    "sensor": 2, "vehicle": 2,
    "features": 3,
    "matching": 4, "map": 4,
    "place_recognition": 5, "pose_graph": 5,
    "slam": 6, "localization": 6, "calibration": 6, "simulation": 6,
    "ros_bridge": 7, "evaluation": 7,
    "nodelets": 8, "cli": 8,
}
ROOMS_WITH_ROS = {"ros_bridge", "nodelets"}
ROS_INCLUDE = re.compile(
    r"^(ros|rosbag|rosconsole|tf|tf2|tf2_ros|nodelet|pluginlib|class_loader|actionlib|message_filters|"
    r"dynamic_reconfigure|diagnostic_updater|pcl_ros|pcl_conversions|XmlRpc\w*|[a-z0-9_]+_msgs|"
    r"falko_slam/[A-Z]\w*\.h)(/|\.h|$)|^falko_slam/[A-Z]\w*\.h$")
ROS_LIBRARY = re.compile(
    r"lib(ros|cpp_common|tf|nodelet|pluginlib|class_loader|xmlrpcpp|actionlib|message_filters|"
    r"dynamic_reconfigure|diagnostic|pcl_ros|topic_tools|bond)")


def sources():
    for folder in ("include", "src"):
        for path in sorted((SOURCE / folder).rglob("*")):
            if path.suffix in (".hpp", ".cpp"):
                yield path


def all_cpp():
    yield from sources()
    for path in sorted((SOURCE / "test").rglob("*")):
        if path.suffix in (".hpp", ".cpp"):
            yield path


def room_of(path):
    parts = path.relative_to(SOURCE).parts
    return parts[2] if parts[0] == "include" else parts[1]


def includes(path):
    return re.findall(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', path.read_text(), re.MULTILINE)


def test_every_file_has_a_room():
    assert {room_of(path) for path in sources()} <= set(FLOORS)


def test_rooms_include_downward_only():
    wrong = []
    for path in sources():
        room = room_of(path)
        for include in includes(path):
            match = re.match(r"falko_slam/([a-z0-9_]+)/", include)
            if match and match[1] != room and FLOORS[match[1]] >= FLOORS[room]:
                wrong.append(f"{path.relative_to(SOURCE)} includes {include}")
    assert not wrong


# So it compiles alone; test/CMakeLists.txt sees to the headers that have no source of their own.
def test_a_source_includes_its_own_header_first():
    wrong = []
    for path in sources():
        header = f"falko_slam/{room_of(path)}/{path.stem}.hpp"
        if path.suffix == ".cpp" and (SOURCE / "include" / header).exists():
            if includes(path)[0] != header:
                wrong.append(f"{path.relative_to(SOURCE)} includes {includes(path)[0]} first")
    assert not wrong


def test_every_public_header_has_a_test():
    tested = set()
    for path in (SOURCE / "test").rglob("*.[ch]pp"):
        tested.update(includes(path))
    headers = [str(path.relative_to(SOURCE / "include"))
               for path in sorted((SOURCE / "include").rglob("*.hpp"))]
    assert [header for header in headers if header not in tested] == []


def test_the_core_includes_no_ros():
    wrong = [f"{path.relative_to(SOURCE)} includes {include}" for path in sources()
             if room_of(path) not in ROOMS_WITH_ROS
             for include in includes(path) if ROS_INCLUDE.match(include)]
    assert not wrong


def test_ros_includes_are_recognised():
    found = [path for path in sources() if any(ROS_INCLUDE.match(i) for i in includes(path))]
    assert {room_of(path) for path in found} == ROOMS_WITH_ROS


def test_public_headers_know_no_ceres():
    wrong = [path for path in sources() if "include" in path.relative_to(SOURCE).parts[0]
             and any(include.startswith("ceres/") for include in includes(path))]
    assert not wrong


def linked_ros_libraries(library):
    text = subprocess.run(["ldd", str(LIBRARIES / library)], check=True, capture_output=True,
                          text=True).stdout
    return [name for name in re.findall(r"^\s*(\S+)", text, re.MULTILINE) if ROS_LIBRARY.match(name)]


def test_the_core_links_no_ros_library():
    assert linked_ros_libraries("libfalko_slam_core.so") == []


def test_linked_ros_libraries_are_recognised():
    assert "libroscpp.so" in "".join(linked_ros_libraries("libfalko_slam_ros_bridge.so"))


def test_python_imports_the_messages():
    folder = next(LIBRARIES.glob("python3*/*-packages"))
    environment = {**os.environ, "PYTHONPATH": f"{folder}:{os.environ.get('PYTHONPATH', '')}"}
    subprocess.run([sys.executable, "-c", "import falko_slam.msg, falko_slam.srv"], check=True, env=environment)


def test_every_file_names_its_licence():
    assert [path for path in all_cpp() if "SPDX-License-Identifier: BSD-3-Clause"
            not in path.read_text().splitlines()[1]] == []


@pytest.mark.parametrize("path", sorted((SOURCE / "launch").glob("*.launch")), ids=lambda path: path.name)
def test_launch_files_are_whole(path):
    error = roslaunch.rlutil.check_roslaunch(str(path), ignore_unset_args=True)
    assert not error, error


def test_clang_format_14_changes_nothing():
    program = shutil.which("clang-format-14") or shutil.which("clang-format")
    if program is None:
        pytest.skip("clang-format is not installed")
    version = subprocess.run([program, "--version"], capture_output=True, text=True).stdout
    if " 14." not in version:
        pytest.skip(f"needs clang-format 14, this is {version.strip()}")
    result = subprocess.run([program, "--dry-run", "--Werror", *map(str, all_cpp())],
                            capture_output=True, text=True)
    assert result.returncode == 0, result.stderr

from setuptools import setup

setup(
    name="alltact_ros",
    version="0.1.0",
    packages=["alltact_ros"],
    data_files=[("share/ament_index/resource_index/packages", ["resource/alltact_ros"]), ("share/alltact_ros", ["package.xml"])],
    install_requires=["setuptools", "numpy"],
    zip_safe=True,
    maintainer="The AllTact authors",
    maintainer_email="alltact@users.noreply.github.com",
    description="What alltact serve measures of a silicone finger, as ROS 2 messages",
    license="BSD-3-Clause",
    entry_points={"console_scripts": ["finger = alltact_ros.node:main"]},
)

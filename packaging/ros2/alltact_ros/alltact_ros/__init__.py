"""What `alltact serve` measures, as ROS 2 messages."""

"""A rosbag2 database by Python's own sqlite3: `db3.py write FILE` takes JSON on standard input, `db3.py
read FILE` prints its messages as JSON lines. Bytes are hexadecimal."""

import json
import sqlite3
import sys


def write(path):
    bag = json.load(sys.stdin)
    database = sqlite3.connect(path)
    database.executescript(
        "CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT NOT NULL, type TEXT NOT NULL,"
        " serialization_format TEXT NOT NULL, offered_qos_profiles TEXT NOT NULL);"
        "CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER NOT NULL,"
        " timestamp INTEGER NOT NULL, data BLOB NOT NULL);"
        "CREATE INDEX timestamp_idx ON messages (timestamp ASC);"
    )
    if bag["definitions"]:
        database.execute(
            "CREATE TABLE message_definitions(id INTEGER PRIMARY KEY, topic_type TEXT NOT NULL,"
            " encoding TEXT NOT NULL, encoded_message_definition TEXT NOT NULL,"
            " type_description_hash TEXT NOT NULL)"
        )
    for type_, text in bag["definitions"].items():
        database.execute(
            "INSERT INTO message_definitions VALUES (NULL, ?, 'ros2msg', ?, '')", (type_, text)
        )
    for number, topic in enumerate(bag["topics"], 1):
        database.execute(
            "INSERT INTO topics VALUES (?, ?, ?, 'cdr', '')", (number, topic["name"], topic["type"])
        )
    for message in bag["messages"]:
        database.execute(
            "INSERT INTO messages VALUES (NULL, ?, ?, ?)",
            (message["topic"] + 1, int(message["log"]), bytes.fromhex(message["data"])),
        )
    database.commit()
    database.close()


def read(path):
    database = sqlite3.connect(f"file:{path}?mode=ro&immutable=1", uri=True)
    rows = database.execute(
        "SELECT t.name, t.type, m.timestamp, m.data FROM messages m JOIN topics t"
        " ON t.id = m.topic_id ORDER BY m.id"
    )
    for name, type_, log, data in rows:
        print(json.dumps({"topic": name, "type": type_, "log": str(log), "data": data.hex()}))


{"write": write, "read": read}[sys.argv[1]](sys.argv[2])

#!/usr/bin/env python3
"""Writes fuzz/corpus/bag/packed_bz2.bag and packed_lz4.bag: one_message.bag with its chunk packed.

Usage: fuzz/packed_bags.py (needs the program lz4)
"""
import bz2
import pathlib
import struct
import subprocess

MAGIC = b'#ROSBAG V2.0\n'
CORPUS = pathlib.Path(__file__).parent / 'corpus' / 'bag'
CHUNK, HEADER = 5, 3


def take_block(data, at):
    """The bytes behind a length at `at`, and where they end."""
    (size,) = struct.unpack_from('<I', data, at)
    return data[at + 4:at + 4 + size], at + 4 + size


def block(data):
    return struct.pack('<I', len(data)) + data


def fields_of(header):
    fields, at = {}, 0
    while at < len(header):
        field, at = take_block(header, at)
        name, value = field.split(b'=', 1)
        fields[name] = value
    return fields


def record(fields, data):
    return block(b''.join(block(name + b'=' + value) for name, value in fields.items())) + block(data)


def records_of(bag):
    at = len(MAGIC)
    while at < len(bag):
        header, at = take_block(bag, at)
        data, at = take_block(bag, at)
        yield fields_of(header), data


def packed(bag, name, pack):
    """The bag with its chunk packed and the place of the index moved by the difference."""
    records = list(records_of(bag))
    shift = 0
    for i, (fields, data) in enumerate(records):
        if fields[b'op'][0] != CHUNK:
            continue
        before = len(record(fields, data))
        records[i] = ({**fields, b'compression': name}, pack(data))
        shift += len(record(*records[i])) - before
    for fields, _ in records:
        if fields[b'op'][0] == HEADER:
            (position,) = struct.unpack('<Q', fields[b'index_pos'])
            fields[b'index_pos'] = struct.pack('<Q', position + shift)
    return MAGIC + b''.join(record(*each) for each in records)


def lz4(data):
    """A frame as librosbag reads it: independent blocks of 64 kB, checksum of the content."""
    return subprocess.run(['lz4', '-c', '-B4', '-'], input=data, stdout=subprocess.PIPE, check=True).stdout


def main():
    bag = (CORPUS / 'one_message.bag').read_bytes()
    (CORPUS / 'packed_bz2.bag').write_bytes(packed(bag, b'bz2', bz2.compress))
    (CORPUS / 'packed_lz4.bag').write_bytes(packed(bag, b'lz4', lz4))


if __name__ == '__main__':
    main()

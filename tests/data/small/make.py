#!/usr/bin/env python3
"""Makes this folder's images from those of ../anthro1 (needs numpy).

Every voxel of the small images covers 2 x 2 x 3 voxels of 1 mm: images are
averaged, labels take the commonest value (of equally common ones the
smallest). What does not fill a block at the upper end of an axis is left out.
Physical positions are kept, so the landmarks stay true.

The prone pair stays NIfTI with its direction (-1, -1, 1); the supine pair is
turned to direction (1, 1, 1) and stored as NRRD (image) and MetaImage (labels).
"""

import gzip
import pathlib
import shutil
import struct
import zlib

import numpy as np

HERE = pathlib.Path(__file__).resolve().parent
SOURCE = HERE.parent / "anthro1"
BLOCK = (2, 2, 3)
NIFTI_TYPE = {"uint8": 2, "int16": 4, "float32": 16}


def read_nifti(path):
    """Values with the first axis first, and the origin of voxel 0 in RAS mm.

    Reads only what ../anthro1 holds: little-endian NIfTI-1, spacing 1 mm, axes
    along RAS.
    """
    data = gzip.decompress(path.read_bytes())
    size = struct.unpack_from("<3h", data, 42)
    code = struct.unpack_from("<h", data, 70)[0]
    offset = int(struct.unpack_from("<f", data, 108)[0])
    affine = np.array(struct.unpack_from("<12f", data, 280)).reshape(3, 4)
    assert np.array_equal(affine[:, :3], np.eye(3)), f"{path}: not a 1 mm RAS grid"
    dtype = {number: name for name, number in NIFTI_TYPE.items()}[code]
    values = np.frombuffer(data, dtype, int(np.prod(size)), offset)
    return values.reshape(size, order="F"), affine[:, 3]


def blocks(values):
    """The voxels of each block along a fourth axis."""
    count = [n // b for n, b in zip(values.shape, BLOCK)]
    inside = values[tuple(slice(0, n * b) for n, b in zip(count, BLOCK))]
    split = inside.reshape(count[0], BLOCK[0], count[1], BLOCK[1], count[2], BLOCK[2])
    return split.transpose(0, 2, 4, 1, 3, 5).reshape(*count, -1)


def average(values):
    return np.rint(blocks(values).mean(axis=3, dtype=float)).astype("int16")


def commonest(labels):
    votes = [(blocks(labels) == label).sum(axis=3) for label in range(labels.max() + 1)]
    return np.argmax(votes, axis=0).astype("uint8")


def write_nifti(path, values, origin_ras):
    affine = np.column_stack([np.diag(BLOCK), origin_ras]).astype(float)
    header = bytearray(352)
    struct.pack_into("<i", header, 0, 348)
    struct.pack_into("<8h", header, 40, 3, *values.shape, 1, 1, 1, 1)
    struct.pack_into("<2h", header, 70, NIFTI_TYPE[values.dtype.name], 8 * values.itemsize)
    struct.pack_into("<8f", header, 76, 1, *BLOCK, 1, 1, 1, 1)
    struct.pack_into("<3f", header, 108, 352, 1, 0)
    header[123] = 2  # mm
    struct.pack_into("<2h", header, 252, 1, 1)
    struct.pack_into("<6f", header, 256, 0, 0, 0, *origin_ras)
    struct.pack_into("<12f", header, 280, *affine.flat)
    header[344:348] = b"n+1\0"
    path.write_bytes(gzip.compress(bytes(header) + values.tobytes("F"), 9, mtime=0))


def numbers(values):
    return " ".join(f"{value:g}" for value in values)


def write_nrrd(path, values, origin_lps):
    vectors = " ".join("(" + ",".join(f"{v:g}" for v in row) + ")" for row in np.diag(BLOCK))
    header = f"""NRRD0004
type: short
dimension: 3
space: left-posterior-superior
sizes: {numbers(values.shape)}
space directions: {vectors}
kinds: domain domain domain
endian: little
encoding: gzip
space origin: ({",".join(f"{v:g}" for v in origin_lps)})

"""
    path.write_bytes(header.encode() + gzip.compress(values.tobytes("F"), 9, mtime=0))


def write_metaimage(path, values, origin_lps):
    packed = zlib.compress(values.tobytes("F"), 9)
    header = f"""ObjectType = Image
NDims = 3
BinaryData = True
BinaryDataByteOrderMSB = False
CompressedData = True
CompressedDataSize = {len(packed)}
TransformMatrix = 1 0 0 0 1 0 0 0 1
Offset = {numbers(origin_lps)}
CenterOfRotation = 0 0 0
AnatomicalOrientation = RAI
ElementSpacing = {numbers(BLOCK)}
DimSize = {numbers(values.shape)}
ElementType = MET_UCHAR
ElementDataFile = LOCAL
"""
    path.write_bytes(header.encode() + packed)


def turned(values, origin_ras):
    """The same voxels with axes along LPS, and their origin in LPS mm."""
    last = origin_ras + (np.array(values.shape) - 1) * BLOCK
    return values[::-1, ::-1, :], np.array([-last[0], -last[1], origin_ras[2]])


def small(name, reduce):
    values, origin = read_nifti(SOURCE / name)
    return reduce(values), origin + (np.array(BLOCK) - 1) / 2


def main():
    write_nifti(HERE / "prone.nii.gz", *small("prone.nii.gz", average))
    write_nifti(HERE / "prone_labels.nii.gz", *small("prone_labels.nii.gz", commonest))
    write_nrrd(HERE / "supine.nrrd", *turned(*small("supine.nii.gz", average)))
    write_metaimage(HERE / "supine_labels.mha", *turned(*small("supine_labels.nii.gz", commonest)))
    shutil.copyfile(SOURCE / "landmarks.csv", HERE / "landmarks.csv")


if __name__ == "__main__":
    main()

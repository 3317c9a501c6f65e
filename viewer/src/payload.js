// The payload that the page was made with, decoded into typed arrays. World frame, metres.

function decodeBytes(base64) {
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  return bytes;
}

// Typed arrays use the machine's byte order; every browser's is little endian, as the payload is.
function decodeAs(Type, base64) {
  return base64 ? new Type(decodeBytes(base64).buffer) : new Type(0);
}

function decodePositions({ encoding, data, min, step }) {
  if (encoding === 'f32') return decodeAs(Float32Array, data);
  const steps = decodeAs(Uint16Array, data);
  const positions = new Float32Array(steps.length);
  for (let i = 0; i < steps.length; ++i) positions[i] = min[i % 3] + steps[i] * step[i % 3];
  return positions;
}

function decodeNormals(base64) {
  const bytes = decodeAs(Int8Array, base64);
  const normals = new Float32Array(bytes.length);
  for (let i = 0; i < bytes.length; ++i) normals[i] = bytes[i] / 127;
  return normals;
}

function decodeCloud(cloud) {
  const positions = decodePositions(cloud.positions);
  return {
    count: positions.length / 3,
    positions,
    normals: decodeNormals(cloud.normals),
    colors: decodeAs(Uint8Array, cloud.colors),
  };
}

function decodeObject(object, index) {
  return {
    ...object,
    index,
    points: decodeAs(Uint32Array, object.points),
    completed: decodeCloud(object.completed),
  };
}

export function decodePayload(payload) {
  return {
    ...payload,
    cloud: decodeCloud(payload.cloud),
    objects: payload.objects.map(decodeObject),
  };
}

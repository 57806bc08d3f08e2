// Arrays as they were packed: base64 around gzip around numbers.
const bytesOf = (letters) => {
  if (Uint8Array.fromBase64) return Uint8Array.fromBase64(letters);
  const text = atob(letters);
  const bytes = new Uint8Array(text.length);
  for (let k = 0; k < text.length; k++) bytes[k] = text.charCodeAt(k);
  return bytes;
};
const KINDS = { Uint8Array, Uint16Array, Uint32Array, Int16Array, Float32Array };
const unpacked = async ({ kind, content }) => {
  const stream = new Blob([bytesOf(content)]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new KINDS[kind](await new Response(stream).arrayBuffer());
};
const unpackedFields = async (fields) => {
  const entries = await Promise.all(
    Object.entries(fields).map(async ([name, value]) => [name, value?.kind ? await unpacked(value) : value]),
  );
  return Object.fromEntries(entries);
};
// Where each list begins in what holds all of them, one after the other.
const startsOf = (counts) => {
  const starts = new Uint32Array(counts.length + 1);
  for (let k = 0; k < counts.length; k++) starts[k + 1] = starts[k] + counts[k];
  return starts;
};
// A canvas of as many pixels as the screen has for it; returns what draws on it in CSS pixels.
const fitted = (canvas) => {
  const ratio = devicePixelRatio || 1;
  const width = Math.max(1, Math.round(canvas.clientWidth * ratio));
  const height = Math.max(1, Math.round(canvas.clientHeight * ratio));
  if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
  const context = canvas.getContext("2d");
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  return { context, width: width / ratio, height: height / ratio };
};

// A number as a colour: viridis, dark to bright, told apart by readers with any colour vision.

const stops = ['#440154', '#3b528b', '#21918c', '#5ec962', '#fde725'];

function mixed(a, b, t) {
  const part = (colour, i) => parseInt(colour.slice(1 + 2 * i, 3 + 2 * i), 16);
  const sum = [0, 1, 2].map((i) => Math.round(part(a, i) * (1 - t) + part(b, i) * t));
  return `rgb(${sum.join(',')})`;
}

export function gradientColour(value, low, high) {
  const t = Math.min(1, Math.max(0, (value - low) / (high - low || 1))) * (stops.length - 1);
  const i = Math.min(stops.length - 2, Math.floor(t));
  return mixed(stops[i], stops[i + 1], t - i);
}

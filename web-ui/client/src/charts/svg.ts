// A chart as SVG text, drawn anew without a canvas; loaded only when somebody saves one.

import { SVGRenderer } from 'echarts/renderers';
import { init, use } from 'echarts/core';
import type { AnyOption } from './echarts';

export function svgText(option: AnyOption, width: number, height: number, background: string): string {
  use([SVGRenderer]);
  const instance = init(null, null, { renderer: 'svg', ssr: true, width: Math.max(320, width), height: Math.max(160, height) });
  instance.setOption({ backgroundColor: background, ...option });
  const text = instance.renderToSVGString();
  instance.dispose();
  return text;
}

import { button, element } from '../dom.js';
import { report } from '../report.js';
import { certificateBoundsFigure } from './bounds.js';
import { certificateDeviceFigure, showDevicePages } from './device_page.js';
import { certificateDevicesFigure } from './devices.js';
import { certificateHeadFigure } from './head.js';
import { certificateLimitsFigure } from './limits.js';
import { certificateLoopFigure } from './loop.js';
import { certificateRemarksFigure } from './remarks.js';
import { certificateRecordsFigure, certificateSignatureFigure } from './signatures.js';

export const certificateSection = {
  id: 'certificate',
  title: 'Certificate',
  controls: certificateControls,
  adorn: mark,
  // The lot's page comes first, then a page for each device, then the tables that may be long.
  figures: [
    certificateHeadFigure, certificateLimitsFigure, certificateDevicesFigure, certificateLoopFigure, certificateRemarksFigure, certificateSignatureFigure,
    certificateDeviceFigure, certificateBoundsFigure, certificateRecordsFigure,
  ],
};

// Marks a certificate that does not prove a pass: it gets a text such as "LIMITS NOT VERIFIED" across every page. The
// text is a background, because browsers repeat a background on every printed page.
function mark(section) {
  const { mark: text, mark_is_red: red } = report.result;
  if (!text) return;
  const svg =
    '<svg xmlns="http://www.w3.org/2000/svg" width="680" height="460"><text x="340" y="250" text-anchor="middle" transform="rotate(-24 340 230)"' +
    ' font-family="sans-serif" font-weight="700" font-size="' + (text.length > 12 ? 54 : 84) + '" fill="' + (red ? '#bc4214' : '#808a92') +
    '" fill-opacity="0.2">' + text + '</text></svg>';
  section.classList.add('marked');
  section.dataset.mark = text;
  section.style.backgroundImage = 'url("data:image/svg+xml,' + encodeURIComponent(svg) + '")';
}

function certificateControls() {
  const print = () => {
    document.documentElement.dataset.only = 'certificate';
    showDevicePages({ all: true });
    window.print();
  };
  return [button('Print the certificate', print, { class: 'action' }), element('span', { class: 'muted' }, 'The lines below can be filled in here before printing.')];
}

export function afterPrintingCertificate() {
  if (!document.documentElement.dataset.only) return;
  delete document.documentElement.dataset.only;
  showDevicePages({ all: false });
}

// Extension 2: an anti-aliased display. Worth no marks; ./radlab check antialias judges it.
//
// Extensions.h brings all that ProgRef.h does, and PictureView and radlab::Image.

#include "Extensions.h"

// Fill the picture. Cut each pixel into samples x samples squares of the same size, ask the view for the radiance at
// the centre of each, and show the mean: one display value, made of the mean radiance. Pixel (x, y) is the square from
// (x, y) to (x + 1, y + 1) of the view, so its centre is (x + 0.5, y + 0.5). Light adds up, display values do not: the
// tone curve of view.display comes last.
// You may call: view.radiance, view.display, picture.width, picture.height; picture.at(x, y) is a pixel that can be
// set.
void antialias(const PictureView& view, int samples, radlab::Image& picture) {
    // TODO extension 2
    (void)view, (void)samples, (void)picture;
    throw NotImplemented("antialias");
}

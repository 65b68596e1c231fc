% A vase, turned, with every facet drawn: for a pen plotter.
%
% Source: made up.
% Units:  millimetres, right-handed; z is up.

segment(1, solid, turning(outline([[0,0], [38,0], [42,3], [40,8], [52,26],
                                   [60,46], [62,64], [58,84], [46,104],
                                   [33,120], [26,134], [25,146], [29,158],
                                   [38,168], [36,170], [26,159], [21,146],
                                   [22,132], [29,117], [42,101], [54,82],
                                   [58,64], [56,47], [48,28], [36,10],
                                   [0,8]]),
                          facets(72))).

view(300, 64, 0).

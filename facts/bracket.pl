% A bracket for a bearing: a CSG tree, with what the title block of its drawing
% says. Segment 6, which is no operand, is the model.
%
% Source: made up.
% Units:  millimetres, right-handed.

segment(1, solid, named(plate, box(size(120, 64, 12)))).
segment(2, solid, named(upright,
                        at([translate(-53, 0, 0)], box(size(14, 64, 62))))).
segment(3, solid, named(boss,
                        at([rotate(y, 90), translate(-64, 0, 62)],
                           cylinder(radius(32), height(36), facets(96))))).
segment(4, solid, named(rib,
                        at([rotate(x, 90), translate(-46, 5, 12)],
                           prism(outline([[-2,-2], [60,-2], [60,0], [18,26],
                                          [-2,26]]),
                                 height(10))))).
segment(5, solid, named(bolts,
                        union([at([translate(38, 20, -1)],
                                  cylinder(radius(5.5), height(14),
                                           facets(48))),
                               at([translate(38, -20, -1)],
                                  cylinder(radius(5.5), height(14),
                                           facets(48))),
                               at([translate(38, 20, 8)],
                                  cylinder(radius(9), height(5), facets(48))),
                               at([translate(38, -20, 8)],
                                  cylinder(radius(9), height(5),
                                           facets(48)))]))).
segment(6, solid,
        named(bracket,
              difference([union([1, 2, 3, 4]),
                          at([rotate(y, 90), translate(-70, 0, 62)],
                             cylinder(radius(17), height(50), facets(96))),
                          at([rotate(y, 90), translate(-70, 0, 62)],
                             cylinder(radius(22), height(18), facets(96))),
                          5]))).

title_block(name, "축받이 브래킷").
title_block(number, "SG-0017").
title_block(material, "GC200").
title_block(company, "상관 기계").
title_block(revision, "A").
title_block(sheet, "1/1").

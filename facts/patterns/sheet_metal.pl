% A duct and a tray of thin sheet metal, for seams with allowances.
%
% Source: made up.
% Units:  millimetres, right-handed; z is up.
%
%     sanggwan unfold facts/patterns/sheet_metal.pl --lock-seam 6 -o sheet.svg

segment(1, solid, named(duct, cylinder(radius(30), height(50), facets(48)))).
segment(2, solid, at([translate(100,0,0)],
                     named(tray, box(size(60,40,30))))).

unfolding(1, removed([base, top])).
unfolding(2, removed([top])).

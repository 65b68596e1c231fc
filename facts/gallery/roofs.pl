% A house with a wing and a dormer: valleys and eaves are where roofs meet.
%
% Source: made up.
% Units:  metres, right-handed; z is up.

segment(1, solid, named(house, at([rotate(x, 90), rotate(z, 90),
                                   translate(-6, 0, 0)],
                                  prism(outline([[-4,0], [4,0], [4,3],
                                                 [4.4,3], [0,7], [-4.4,3],
                                                 [-4,3]]), height(12))))).
segment(2, solid, named(wing, at([rotate(x, 90), translate(3, 0, 0)],
                                 prism(outline([[-2.5,0], [2.5,0], [2.5,2.6],
                                                [2.8,2.6], [0,5.2],
                                                [-2.8,2.6], [-2.5,2.6]]),
                                       height(8))))).
segment(3, solid, named(dormer, at([rotate(x, 90), translate(-2.5, -1, 0)],
                                   prism(outline([[-0.9,3.4], [0.9,3.4],
                                                  [0.9,4.8], [0,5.8],
                                                  [-0.9,4.8]]), height(2.4))))).
segment(4, solid, named(chimney, at([translate(-3.8, 1.0, 3)],
                                    box(size(0.8, 0.8, 4.6))))).
segment(5, solid, named(home, union([1, 2, 3, 4]))).

view(300, 66, 0).

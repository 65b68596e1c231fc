:- module(sg_unfold_plate,
          [ plate_measures/4,           % +D, +Area, +Options, -Measures
            material/2                  % ?Name, -Density
          ]).
:- use_module('../sheet/sheet_paper', [unit_millimetres/2]).
:- use_module('../store', [e/5, edge_polygon/3, joint/6, v/5]).
:- use_module(library(option), [option/2, option/3]).
/** <module> What a workshop asks of a pattern in plate: its bends, its weight.
*/

%!  material(?Name, -Density) is nondet.
%
%   Density, in kg/m3, is what is usually reckoned with for Name.

material(steel,     7850).
material(stainless, 7900).
material(aluminium, 2700).
material(copper,    8960).
material(brass,     8500).
material(zinc,      7140).
material(titanium,  4510).

%!  plate_measures(+D, +Area, +Options, -Measures:dict) is det.
%
%   Measures are of pattern D, of Area, in plate of thickness(T):
%
%     - bends       a dict for each fold that bends by more than half a degree,
%                   in the order of their numbers: fold, edge, polygons (two),
%                   length, angle in degrees, direction (`down`: away from who
%                   sees the pattern from outside; or `up`), radius inside
%     - weight      with material(Name), in kg; unit(U) says what one is
%
%   Options are those of the verb, or as of how_wished/3. Lengths are in units
%   of the model.

plate_measures(D, Area, Options, Measures) :-
    option(thickness(T), Options),
    radius(Options, T, Radius),
    findall(Bend, bend(D, Radius, Bend), Bends),
    (   option(material(Name), Options)
    ->  material(Name, Density),
        option(unit(Unit), Options, mm),
        unit_millimetres(Unit, Millimetres),
        Weight is Area*T*Density*(Millimetres/1000)**3,
        Measures = _{bends:Bends, material:Name, weight:Weight}
    ;   Measures = _{bends:Bends}
    ).

radius(Options, T, Radius) :-
    (   option('bend-radius'(Radius0), Options)
    ->  Radius = Radius0
    ;   option(bend_radius(Radius), Options, T)
    ).

bend(D, Radius, _{fold:J, edge:E1, polygons:[P1,P2], length:Length,
                  angle:Degrees, direction:Direction, radius:Radius}) :-
    joint(D, J, E1, E2, fold, Angle),
    abs(Angle) > 0.5,
    Degrees is abs(Angle),
    (   Angle > 0
    ->  Direction = down
    ;   Direction = up
    ),
    edge_polygon(D, E1, P1),
    edge_polygon(D, E2, P2),
    e(D, E1, A, B, _),
    v(D, A, XA, YA, _),
    v(D, B, XB, YB, _),
    Length is sqrt((XB-XA)**2 + (YB-YA)**2).

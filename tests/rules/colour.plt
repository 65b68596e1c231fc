/* Colours by name and in bytes. */
:- module(test_colour, []).
:- use_module(library(plunit)).
:- use_module(rules(colour)).

:- begin_tests(colour).

test(bytes, RGBs == [rgb(0,0,0),rgb(255,255,255),rgb(0,255,1)]) :-
    findall(RGB, ( member(RGB0, [ rgb(0,0,0), rgb(255,255,255), rgb(0,255,1),
                                  rgb(256,0,0), rgb(0,256,0), rgb(0,0,256),
                                  rgb(-1,0,0), rgb(0,-1,0), rgb(0,0,-1),
                                  rgb(1.0,0,0), rgb(0,a,0) ]),
                   colour_rgb(RGB0, RGB) ),
            RGBs).
test(names, true(All == RGBs)) :-
    findall(RGB, colour_name(_, RGB), All),
    findall(RGB, ( colour_name(Name, _), colour_rgb(Name, RGB) ), RGBs).
test(no_name, fail) :-
    colour_rgb(mauve, _).

:- end_tests(colour).

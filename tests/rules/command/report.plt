:- encoding(utf8).
/* How a report is printed: each line where there is something to say, in both
   languages. */
:- module(test_report, []).
:- use_module(library(apply)).
:- use_module(library(lists)).
:- use_module(library(plunit)).
:- use_module(library(http/json)).
:- use_module(library(yall)).
:- use_module(rules(command/report)).
:- use_module(rules(model/integrity), [defect_weight/2]).

%   A segment of nothing, and a shell; Changes say what else there is.

segment(Changes, Segment) :-
    Segment0 = _{ segment:3, name:"x", kind:solid, vertices:1, half_edges:0,
                  edges:2, polygons:0, triangles:1234, curve_edges:0,
                  box:[[0.5,1.0,2.0],[3.0,4.0,5.0]], area:6.0, volume:null,
                  length:2.5, border_edges:0, shells:[], faults:_{},
                  remarks:_{}, meetings:[] },
    Segment = Segment0.put(Changes).

shell(Changes, Shell) :-
    Shell0 = _{ polygon:1, vertices:8, edges:12, polygons:6, closed:true,
                euler:null, genus:null, area:6.0, volume:1.0, depth:0 },
    Shell = Shell0.put(Changes).

parameter(Changes, Parameter) :-
    Parameter0 = _{ name:width, value:5, formula:null, default:null,
                    minimum:null, maximum:null, step:null, text:null },
    Parameter = Parameter0.put(Changes).

%   lines(Language, Report, Lines): what is printed of it.

lines(Language, Parameters, Segments, Faults, Lines) :-
    current_prolog_flag(message_language, Old),
    setup_call_cleanup(
        set_prolog_flag(message_language, Language),
        with_output_to(string(Text),
                       print_report(text, _{ parameters:Parameters,
                                             segments:Segments,
                                             faults:Faults })),
        set_prolog_flag(message_language, Old)),
    split_string(Text, "\n", "", Lines0),
    once(append(Lines, [""], Lines0)).

of_segment(Language, Changes, Lines) :-
    segment(Changes, Segment),
    lines(Language, [], [Segment], 0, [_,_,_|Lines0]),
    once(append(Lines, [_], Lines0)).

of_shell(Language, Changes, Line) :-
    shell(Changes, Shell),
    of_segment(Language, _{shells:[Shell]}, [Line]).

of_parameter(Language, Changes, Line) :-
    parameter(Changes, Parameter),
    lines(Language, [Parameter], [], 0, [Line,_]).

:- begin_tests(report).

test(least, Lines == [ "segment 3: solid x",
                       "  1 vertex, 2 edges, 0 polygons, 1,234 triangles",
                       "  box          0.5 1.0 2.0 to 3.0 4.0 5.0",
                       "no faults" ]) :-
    segment(_{}, Segment),
    lines(en, [], [Segment], 0, Lines).
test(korean, Lines == [ "세그먼트 3: 입체 x",
                        "  꼭짓점 1개, 모서리 2개, 다각형 0개, 삼각형 1,234개",
                        "  범위           0.5 1.0 2.0에서 3.0 4.0 5.0까지",
                        "잘못이 없습니다" ]) :-
    segment(_{}, Segment),
    lines(ko, [], [Segment], 0, Lines).
test(faults, Last == ["1 fault","2 faults","잘못 2개"]) :-
    findall(Line, ( member(Language-N, [en-1,en-2,ko-2]),
                    lines(Language, [], [], N, [Line]) ), Last).
test(measures, [ forall(member(Changes-Lines,
                   [ _{polygons:1}-["  area         6"],
                     _{polygons:2,volume:0.0}-["  area         6",
                                              "  volume       0"],
                     _{volume: -1.5}-["  volume       -1.5"],
                     _{curve_edges:1}-["  length       2.5"],
                     _{border_edges:1}-["  1 border edge"],
                     _{border_edges:2}-["  2 border edges"] ])),
                 true(Found == Lines) ]) :-
    of_segment(en, Changes, Found).
test(measures_ko, Found == [ "  넓이           6", "  부피           1",
                             "  길이           2.5", "  경계 모서리 3개" ]) :-
    of_segment(ko, _{polygons:1, volume:1.0, curve_edges:1, border_edges:3},
               Found).
test(shell, [ forall(member(Language-Changes-Line,
    [ en-_{}-"  shell of 6 polygons: closed",
      en-_{closed:false,polygons:1}-"  shell of 1 polygon: open",
      en-_{euler:0,genus:1}-
          "  shell of 6 polygons: closed, Euler characteristic 0, genus 1",
      en-_{depth:1}-"  shell of 6 polygons: closed, inside 1 other",
      ko-_{closed:false,euler:2,genus:0,depth:2}-
          "  껍질(다각형 6개): 열림, 오일러 지표 2, 종수 0, 다른 껍질 2개 안" ])),
              true(Found == Line) ]) :-
    of_shell(Language, Changes, Found).
test(parameter, [ forall(member(Language-Changes-Line,
    [ en-_{}-"parameter width = 5",
      en-_{formula:"a+1",default:"7"}-
          "parameter width = 5, from a+1, which was set (default 7)",
      en-_{minimum:0,maximum:9,step:3}-
          "parameter width = 5, 0 to 9 in steps of 3",
      en-_{minimum:0}-"parameter width = 5, 0 at least",
      en-_{maximum:9}-"parameter width = 5, 9 at most",
      en-_{text:_{en:"how wide",ko:"너비"}}-"parameter width = 5: how wide",
      en-_{text:_{ko:"너비"}}-"parameter width = 5: 너비",
      ko-_{text:_{en:"how wide",ko:"너비"}}-"매개변수 width = 5: 너비",
      ko-_{formula:"a+1",default:"7"}-
          "매개변수 width = 5, 식 a+1, 주어진 값 (기본값 7)",
      ko-_{minimum:0,maximum:9,step:3}-
          "매개변수 width = 5, 0부터 9까지, 간격 3",
      ko-_{minimum:0}-"매개변수 width = 5, 0 이상",
      ko-_{maximum:9}-"매개변수 width = 5, 9 이하",
      en-_{name:'Two words'}-"parameter 'Two words' = 5" ])),
                  true(Found == Line) ]) :-
    of_parameter(Language, Changes, Found).
%   A name of 67 characters is as short as what stands for a longer one.
test(long_name, [ forall(member(Length-Shown-Dots, [64-64-'', 67-67-'',
                                                    68-64-'...'])),
                  true(Found == Line) ]) :-
    length(Codes, Length),
    maplist(=(0'n), Codes),
    string_codes(Name, Codes),
    sub_string(Name, 0, Shown, _, Start),
    format(string(Line), "segment 3: solid ~w~w", [Start,Dots]),
    segment(_{name:Name}, Segment),
    lines(en, [], [Segment], 0, [Found|_]).
test(defects, Lines-Koreans == [ "  FAULT  open_edge: 1,200",
                                 "  remark short_edge: 2" ]
                              -[ "  잘못     열린 모서리(open_edge): 1,200",
                                 "  참고     짧은 모서리(short_edge): 2" ]) :-
    Changes = _{faults:_{open_edge:1200}, remarks:_{short_edge:2}},
    of_segment(en, Changes, Lines),
    of_segment(ko, Changes, Koreans).
test(every_defect_in_korean, [ forall(defect_weight(Defect, _)),
                               true(Words == [yes]) ]) :-
    dict_pairs(Faults, _, [Defect-1]),
    of_segment(ko, _{faults:Faults}, [Line]),
    format(string(Own), "(~w): 1", [Defect]),
    findall(yes, ( sub_string(Line, Before, _, 0, Own),
                   sub_string(Line, 0, Before, _, Korean),
                   string_codes(Korean, Codes),
                   last(Codes, Code),
                   Code >= 0xac00 ), Words).
test(meeting, Lines-Koreans ==
                  ["  self_penetration: polygons 3 and 7 at 1 2.5 -0.333333"]
               -["  자기 관통(self_penetration): 다각형 3, 7, 위치 1 2.5 -0.333333"]) :-
    Third is -1/3.0,
    Changes = _{meetings:[_{kind:self_penetration, polygons:[3,7],
                            at:[1.0,2.5,Third]}]},
    of_segment(en, Changes, Lines),
    of_segment(ko, Changes, Koreans).
test(json, Pairs == [faults-0,parameters-[],segments-[]]) :-
    with_output_to(string(Text),
                   print_report(json, _{parameters:[], segments:[], faults:0})),
    sub_string(Text, _, 1, 0, "\n"),
    atom_json_dict(Text, Dict, []),
    dict_pairs(Dict, _, Pairs).
test(counted, [ forall(member(What-One-Many, [ vertex-vertex-vertices,
                    edge-edge-edges, polygon-polygon-polygons,
                    triangle-triangle-triangles, shell-shell-shells,
                    border_edge-'border edge'-'border edges',
                    fault-fault-faults ])),
                true(Texts == Wanted) ]) :-
    findall(Text, ( member(N, [0,1,2]), counted(en, What, N, Text) ), Texts),
    maplist([N-Word,Text]>>format(string(Text), "~d ~w", [N,Word]),
            [0-Many,1-One,2-Many], Wanted).

:- end_tests(report).

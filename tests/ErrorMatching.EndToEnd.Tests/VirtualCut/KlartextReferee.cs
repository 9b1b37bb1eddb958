using System.Globalization;

namespace ErrorMatching.EndToEnd.Tests;

/// <summary>
/// A second, deliberately small interpreter of Heidenhain Klartext. It was written from the path functions of the user's manuals and
/// shares no code with the library. What it does not know, it refuses. The tool starts at the origin.
/// </summary>
internal sealed class KlartextReferee
{
    private readonly List<RefereeMove> _moves = [];
    private readonly Dictionary<string, double> _parameters = new(StringComparer.Ordinal);
    private Spot _at;
    private Flat? _center;
    private CutterSide _side = CutterSide.None;

    private KlartextReferee()
    {
    }

    /// <summary>All moves of a program, rapid ones included, in order.</summary>
    public static IReadOnlyList<RefereeMove> Run(string program)
    {
        var referee = new KlartextReferee();
        var lines = program.Split('\n').Select(l => l.Split(';')[0].Trim()).ToArray();
        var repeats = new Dictionary<int, int>();
        for (var i = 0; i < lines.Length; i++)
        {
            var words = lines[i].Split(' ', StringSplitOptions.RemoveEmptyEntries).ToList();
            var number = words.Count > 0 && words[0].All(char.IsAsciiDigit) ? words[0] : "";
            words.RemoveRange(0, number.Length > 0 ? 1 : 0);
            if (words is ["CALL", "LBL", var label, "REP", var count])
            {
                repeats.TryAdd(i, int.Parse(count, CultureInfo.InvariantCulture));
                if (repeats[i]-- > 0)
                {
                    i = Array.FindIndex(
                        lines,
                        l => l.EndsWith($"LBL {label}", StringComparison.Ordinal) && !l.Contains("CALL", StringComparison.Ordinal));
                }
                else
                {
                    repeats.Remove(i);
                }
            }
            else if (words is ["M2" or "M30", ..] or ["END", ..])
            {
                break;
            }
            else
            {
                referee.Execute(words, number, i + 1);
            }
        }

        return referee._moves;
    }

    private void Execute(List<string> words, string number, int line)
    {
        switch (words)
        {
            case [] or ["BEGIN", "PGM", _, "MM"] or ["BLK", "FORM", ..] or ["TOOL", "CALL", ..] or ["LBL", _]:
            case ["M3" or "M5" or "M8" or "M9"]:
                break;
            case ["FN", "0:", var parameter, "=", var value]:
                _parameters[parameter] = Number(value, line);
                break;
            case ["CC", .. var place]:
                var center = Target(place, line, out var rest);
                _center = rest.Count == 0 ? new(center.X, center.Y) : throw Unknown(rest, line);
                break;
            case ["CP", var angle, var sense] when angle.StartsWith("IPA", StringComparison.Ordinal):
                Turn(Number(angle[3..], line), sense, number, line);
                break;
            case [("L" or "C" or "CR") and var function, .. var others]:
                Move(function, others, number, line);
                break;
            default:
                throw Unknown(words, line);
        }
    }

    // About the center by an angle, whose sign is the sense.
    private void Turn(double degrees, string sense, string number, int line)
    {
        if (_center is not { } center || sense != (degrees > 0 ? "DR+" : "DR-") || Math.Abs(degrees) > 360)
        {
            throw new RefereeException($"line {line}: not an arc about a center");
        }

        var radius = _at.In(WorkPlane.XY) - center;
        var (sin, cos) = Math.SinCos(degrees * Math.PI / 180);
        var end = center + new Flat((radius.U * cos) - (radius.V * sin), (radius.U * sin) + (radius.V * cos));
        var to = _at with { X = end.U, Y = end.V };
        _moves.Add(new RefereeMove("N" + number, line, false, _at, to, WorkPlane.XY, _side).Around(center, degrees > 0));
        _at = to;
    }

    private void Move(string function, List<string> words, string number, int line)
    {
        var to = Target(words, line, out var rest);
        var (rapid, sense, radius) = (false, 0, double.NaN);
        foreach (var word in rest)
        {
            switch (word)
            {
                case "FMAX": rapid = true; break;
                case "R0": _side = CutterSide.None; break;
                case "RL": _side = CutterSide.Left; break;
                case "RR": _side = CutterSide.Right; break;
                case "DR+": sense = 1; break;
                case "DR-": sense = -1; break;
                case var _ when word[0] is 'F' or 'M' && char.IsAsciiDigit(word[1]): break;
                case var _ when word[0] == 'R' && function == "CR": radius = Number(word[1..], line); break;
                default: throw Unknown([word], line);
            }
        }

        var move = new RefereeMove("N" + number, line, rapid, _at, to, WorkPlane.XY, _side);
        if ((function == "L") != (sense == 0) || (function == "CR") == double.IsNaN(radius))
        {
            throw new RefereeException($"line {line}: a sense or a radius is missing, or is one too many");
        }

        _moves.Add(function switch
        {
            "L" => move,
            "C" => move.Around(_center ?? throw new RefereeException($"line {line}: no CC"), sense > 0),
            _ => move.Around(CenterOf(move, radius, sense, line), sense > 0),
        });
        _at = to;
    }

    // A positive radius turns by less than half a turn: counter-clockwise, its center is left of the chord.
    private static Flat CenterOf(RefereeMove move, double radius, int sense, int line)
    {
        var (from, chord) = (move.From.In(WorkPlane.XY), move.To.In(WorkPlane.XY) - move.From.In(WorkPlane.XY));
        var half = chord.Length / 2;
        if (half < 1e-9 || half > Math.Abs(radius) + 0.0015)
        {
            throw new RefereeException($"line {line}: R {radius:R} spans no chord of {chord.Length:R}");
        }

        var height = Math.Sqrt(Math.Max(0, (radius * radius) - (half * half)));
        return from + (chord * 0.5) + (chord.Unit().Left * (height * sense * Math.Sign(radius)));
    }

    private Spot Target(List<string> words, int line, out List<string> rest)
    {
        var at = new Dictionary<char, double> { ['X'] = _at.X, ['Y'] = _at.Y, ['Z'] = _at.Z };
        rest = [];
        foreach (var word in words)
        {
            var axis = word[0] == 'I' && word.Length > 1 ? word[1] : word[0];
            if (!at.TryGetValue(axis, out var now))
            {
                rest.Add(word);
            }
            else
            {
                at[axis] = word[0] == 'I' ? now + Number(word[2..], line) : Number(word[1..], line);
            }
        }

        return new(at['X'], at['Y'], at['Z']);
    }

    private double Number(string text, int line)
    {
        var sign = text[0] == '-' ? -1 : 1;
        var digits = text.TrimStart('+', '-');
        return _parameters.TryGetValue(digits, out var value) ? sign * value
            : double.TryParse(digits, NumberStyles.AllowDecimalPoint, CultureInfo.InvariantCulture, out value) ? sign * value
            : throw new RefereeException($"line {line}: {text} is not a number");
    }

    private static RefereeException Unknown(IEnumerable<string> words, int line) =>
        new($"line {line}: {string.Join(' ', words)} is not known here");
}

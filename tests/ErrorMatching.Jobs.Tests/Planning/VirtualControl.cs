using System.Globalization;
using System.Text;
using System.Text.RegularExpressions;
using ErrorMatching.Geometry;

namespace ErrorMatching.Jobs.Tests;

/// <summary>Controls that execute the text of a probing program by their own measuring cycles, on a part of which they know the true shape,
/// and write the log.</summary>
/// <remarks>It shares nothing with what writes the programs. What it takes the cycles for is what the templates say that they assume: TCH
/// PROBE 3 answers with the center of the ball, CYCLE978, P9811 and P9821 with the contact. A line that it does not know fails.</remarks>
internal sealed partial class VirtualControl(VirtualPart part, double ball, double topZ)
{
    private static readonly Point3 Zero = new(0, 0, 0);

    private readonly Dictionary<string, double> _values = new(StringComparer.Ordinal);
    private readonly Dictionary<string, string> _texts = new(StringComparer.Ordinal);
    private readonly Dictionary<string, string> _probing = new(StringComparer.Ordinal);
    private readonly StringBuilder _log = new();
    private Point3 _at = new(0, 0, 500);
    private string _line = "";

    /// <summary>What a cycle answers less what it should, along the direction of the move, in radii of the ball.</summary>
    public double OffByRadii { get; init; }

    /// <summary>First variable of the answer of P9811 and P9821.</summary>
    public int FirstAnswer { get; init; } = 135;

    /// <summary>How often a cycle touched, and how often a skip did.</summary>
    public (int ByCycle, int BySkip) Touches { get; private set; }

    /// <summary>Executes a program and returns its log.</summary>
    /// <param name="program">Its text.</param>
    /// <param name="mask">The file beside it, if there is one.</param>
    public string Run(string program, string? mask)
    {
        var lines = program.Split('\n', StringSplitOptions.RemoveEmptyEntries | StringSplitOptions.TrimEntries);
        for (var i = 0; i < lines.Length; i++)
        {
            _line = lines[i];
            if (_line is "M30" or "M2")
            {
                return _log.ToString();
            }

            if (_line.StartsWith("IF $AC_MEA[1]==0", StringComparison.Ordinal))
            {
                // It touched.
                i = Array.IndexOf(lines, "ENDIF", i);
            }
            else if (!IsSilent() && !Klartext(mask) && !Siemens() && !Iso())
            {
                Assert.Fail($"The control does not know {_line}");
            }
        }

        throw new InvalidOperationException("The program has no end.");
    }

    private bool IsSilent() => Silent().IsMatch(_line);

    private bool Klartext(string? mask)
    {
        if (_line.StartsWith("L ", StringComparison.Ordinal))
        {
            GoTo(_line);
        }
        else if (Assigned().Match(_line) is { Success: true } assigned)
        {
            _values[assigned.Groups["name"].Value] = Number(assigned.Groups["value"].Value);
        }
        else if (_line.StartsWith("QS10 = ", StringComparison.Ordinal))
        {
            _texts["QS10"] = string.Concat(_line[7..].Split("||", StringSplitOptions.TrimEntries).Select(Text));
        }
        else if (_line == "FN 16: F-PRINT EMPROBE.A / EMPROBE.TXT")
        {
            var format = Mask().Match(mask!);
            Assert.True(format.Success, mask);
            _log.Append(_texts[format.Groups["name"].Value]).Append("\r\n");
        }
        else if (_line.StartsWith("FN 9: IF +Q4 EQU -1 GOTO LBL", StringComparison.Ordinal))
        {
            Assert.NotEqual(-1, _values["Q4"]);
        }
        else if (TouchProbe().Match(_line) is { Success: true } probe)
        {
            _probing[probe.Groups["line"].Value] = probe.Groups["rest"].Value;
            if (probe.Groups["line"].Value == "4")
            {
                Measure();
            }
        }
        else
        {
            return false;
        }

        return true;

        string Text(string operand) => operand.StartsWith('"') ? operand.Trim('"')
            : ToChar().Match(operand) is { Success: true } value
                ? _values[value.Groups["name"].Value].ToString("F" + value.Groups["decimals"].Value, CultureInfo.InvariantCulture)
            : throw new InvalidOperationException(operand);
    }

    // TCH PROBE 3: from where the ball is, at an angle from the axis.
    private void Measure()
    {
        Assert.Equal("Q1", _probing["1"]);
        var angle = Direction().Match(_probing["2"]);
        var way = Way().Match(_probing["3"]);
        Assert.True(angle.Success && way.Success, _line);
        var radians = Number(angle.Groups["angle"].Value) * Math.PI / 180;
        var direction = new Vector3(Math.Cos(radians), Math.Sin(radians), 0);
        var touched = part.Touch(_at, _at + (direction * Number(way.Groups["distance"].Value)));
        Answer(touched + (direction * (OffByRadii * ball / 2)), "Q1", "Q2", "Q3");
        _values["Q4"] = 0;
        _at = touched + (direction * -Math.Min(Number(way.Groups["back"].Value), (touched - _at).Length));
        Touches = (Touches.ByCycle + 1, Touches.BySkip);
    }

    private bool Siemens()
    {
        if (Cycle978().Match(_line) is { Success: true } cycle)
        {
            string[] arguments = cycle.Groups["arguments"].Value.Split(',');
            Assert.Equal(22, arguments.Length);
            Assert.Equal(("0", ""), (arguments[0], arguments[1]));
            var (surface, before) = (Number(arguments[4]), Number(arguments[5]));
            var sign = arguments[8] switch { "1" => 1, "2" => -1, _ => throw new InvalidOperationException(_line) };
            var axis = Axis(int.Parse(arguments[7], CultureInfo.InvariantCulture) - 1);

            // The ball goes to its way before the surface, then at most as far behind it.
            var start = Along(axis, surface - (sign * (before + (ball / 2))));
            part.Move(_at, start, topZ, _line);
            var touched = part.Touch(start, Along(axis, surface + (sign * (before - (ball / 2)))));
            _values["_OVR[4]"] = (touched - Zero).Dot(axis) + (sign * ball / 2 * (1 + OffByRadii));
            _at = touched + (axis * (-sign * before));
            Touches = (Touches.ByCycle + 1, Touches.BySkip);
        }
        else if (_line.StartsWith("MEAS=1 G1 ", StringComparison.Ordinal))
        {
            Skip(Target(_line), "$AA_MW[X]", "$AA_MW[Y]", "$AA_MW[Z]");
        }
        else if (Written().Match(_line) is { Success: true } written)
        {
            foreach (var piece in written.Groups["text"].Value.Split("<<"))
            {
                _log.Append(piece.StartsWith('"') ? piece.Trim('"') : _values[piece].ToString("0.######", CultureInfo.InvariantCulture));
            }

            _log.Append('\n');
        }
        else
        {
            return false;
        }

        return true;
    }

    private bool Iso()
    {
        if (_line.StartsWith("G65 P9811 ", StringComparison.Ordinal))
        {
            var axis = Array.FindIndex(["X", "Y", "Z"], a => Word(_line, a) is not null);
            var (surface, direction) = (Word(_line, "XYZ"[axis].ToString())!.Value, Axis(axis));
            var sign = Math.Sign(surface - (_at - Zero).Dot(direction));
            Contact(direction * sign, Math.Abs(surface - (_at - Zero).Dot(direction)) + Word(_line, "Q")!.Value);
        }
        else if (_line.StartsWith("G65 P9821 ", StringComparison.Ordinal))
        {
            var radians = Word(_line, "A")!.Value * Math.PI / 180;
            Contact(new(Math.Cos(radians), Math.Sin(radians), 0), Word(_line, "D")!.Value + Word(_line, "Q")!.Value);
        }
        else if (_line.StartsWith("G65 P9810 ", StringComparison.Ordinal) || Motion().IsMatch(_line))
        {
            GoTo(_line);
        }
        else if (_line.StartsWith("DPRNT[", StringComparison.Ordinal))
        {
            _log.Append(Printed().Replace(
                _line[6..^1].Replace('*', ' '),
                m => _values[m.Groups["name"].Value].ToString("F4", CultureInfo.InvariantCulture).PadLeft(9)));
            _log.Append("\r\n");
        }
        else if (_line is "POPEN" or "PCLOS")
        {
            _log.Append("%\r\n");
        }
        else
        {
            return false;
        }

        return true;
    }

    // The surface, at most so far from the center of the ball, and back to where it began.
    private void Contact(Vector3 direction, double reach)
    {
        var touched = part.Touch(_at, _at + (direction * (reach - (ball / 2))));
        var surface = touched + (direction * (ball / 2 * (1 + OffByRadii)));
        Answer(surface, $"#{FirstAnswer}", $"#{FirstAnswer + 1}", $"#{FirstAnswer + 2}");
        Touches = (Touches.ByCycle + 1, Touches.BySkip);
    }

    private void Skip(Point3 to, string x, string y, string z)
    {
        var touched = part.Touch(_at, to);
        Answer(touched, x, y, z);
        _at = touched;
        Touches = (Touches.ByCycle, Touches.BySkip + 1);
    }

    private void Answer(Point3 place, string x, string y, string z) =>
        (_values[x], _values[y], _values[z]) = (place.X, place.Y, place.Z);

    private void GoTo(string words)
    {
        var to = Target(words);
        part.Move(_at, to, topZ, words);
        _at = to;
    }

    private Point3 Target(string words) => new(Word(words, "X") ?? _at.X, Word(words, "Y") ?? _at.Y, Word(words, "Z") ?? _at.Z);

    private Point3 Along(Vector3 axis, double value) => _at + (axis * (value - (_at - Zero).Dot(axis)));

    private static Vector3 Axis(int index) => index switch { 0 => new(1, 0, 0), 1 => new(0, 1, 0), _ => new(0, 0, 1) };

    private static double? Word(string words, string letter) =>
        Regex.Match(words, $@"(?:^|\s){letter}(?<value>[+-]?[0-9.]+)", RegexOptions.ExplicitCapture, TimeSpan.FromSeconds(1)) is
        { Success: true } word
            ? Number(word.Groups["value"].Value)
            : null;

    private static double Number(string text) => double.Parse(text, CultureInfo.InvariantCulture);

    private const RegexOptions Options = RegexOptions.CultureInvariant | RegexOptions.ExplicitCapture;

    [GeneratedRegex(
        @"^(;.*|\(.*\)|%|O[0-9]+.*|BEGIN PGM .*|TOOL CALL .*|STOP|M[0-9]+( M[0-9]+)?|T[0-9]+( M6)?|D[0-9]+|G17 .*|G54|G710|STOPRE|MSG\(.*\)"
            + @"|DEF .*|DELETE\(.*\)|G65 P983[23]|IF\[.*\]THEN #3000=.*|G0 G43 .*)$",
        Options,
        1000)]
    private static partial Regex Silent();

    [GeneratedRegex(@"^(?<name>Q[0-9]+) = (?<value>[0-9]+)$", Options, 1000)]
    private static partial Regex Assigned();

    [GeneratedRegex(@"^TCH PROBE 3\.(?<line>[0-4]) (?<rest>.*)$", Options, 1000)]
    private static partial Regex TouchProbe();

    [GeneratedRegex(@"^X ANGLE: (?<angle>[+-][0-9.]+)$", Options, 1000)]
    private static partial Regex Direction();

    [GeneratedRegex(@"^DIST \+(?<distance>[0-9.]+) F[0-9.]+ MB(?<back>[0-9.]+) REFERENCE SYSTEM: 0$", Options, 1000)]
    private static partial Regex Way();

    [GeneratedRegex(@"^TOCHAR\( DAT\+(?<name>Q[0-9]+) DECIMALS(?<decimals>[0-9]) \)$", Options, 1000)]
    private static partial Regex ToChar();

    [GeneratedRegex(@"^""%S"",(?<name>QS[0-9]+);\n$", Options, 1000)]
    private static partial Regex Mask();

    [GeneratedRegex(@"^CYCLE978\((?<arguments>.*)\)$", Options, 1000)]
    private static partial Regex Cycle978();

    [GeneratedRegex(@"^WRITE\(_EM_ERR,""ERRORMATCH"",(?<text>.*)\)$", Options, 1000)]
    private static partial Regex Written();

    [GeneratedRegex(@"^G[01] [XYZ]", Options, 1000)]
    private static partial Regex Motion();

    [GeneratedRegex(@"(?<name>#[0-9]+)\[44\]", Options, 1000)]
    private static partial Regex Printed();
}

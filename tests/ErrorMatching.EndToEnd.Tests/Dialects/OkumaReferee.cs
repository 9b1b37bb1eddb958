using System.Globalization;
using System.Text;
using System.Text.RegularExpressions;

namespace ErrorMatching.EndToEnd.Tests;

/// <summary>
/// Okuma's language for the referee: runs a program's variables, branches and calls, and writes each block that it reaches with numbers
/// in place of formulas. It shares no code with the library; what it does not know, it leaves for the referee to refuse.
/// </summary>
internal sealed partial class OkumaReferee
{
    private const int MostBlocks = 10_000;

    private readonly string[] _lines;
    private readonly List<string> _plain = [];
    private readonly Dictionary<string, double> _common = [];
    private (int First, Dictionary<string, double> Names)? _modal;

    private OkumaReferee(string program) => _lines = program.Split('\n');

    /// <summary>The blocks that run, in order, as plain words.</summary>
    public static string Unrolled(string program)
    {
        var referee = new OkumaReferee(program);
        referee.Run(0, []);
        return string.Join('\n', referee._plain);
    }

    [GeneratedRegex(@"\(.*?\)", RegexOptions.ExplicitCapture, 1000)]
    private static partial Regex Comment();

    [GeneratedRegex(@"^(?<name>N[A-Z][A-Z0-9]*|O[A-Z0-9]+)(\s+|$)", RegexOptions.ExplicitCapture, 1000)]
    private static partial Regex Label();

    [GeneratedRegex(@"(?<!\S)(?<name>[A-Z]{2}[A-Z0-9]*)=(?<value>\S+)", RegexOptions.ExplicitCapture, 1000)]
    private static partial Regex Assignment();

    [GeneratedRegex(@"(?<!\S)(?<letter>[A-Z])=\s*(?<value>\S+)", RegexOptions.ExplicitCapture, 1000)]
    private static partial Regex Word();

    [GeneratedRegex(@"^IF \[(?<a>\S+) (?<what>EQ|NE|LT|LE|GT|GE) (?<b>\S+)\] (GOTO )?(?<to>N\S+)$", RegexOptions.ExplicitCapture, 1000)]
    private static partial Regex Condition();

    [GeneratedRegex(@"[XYZ]=?[-+.0-9A-Z\[]", RegexOptions.ExplicitCapture, 1000)]
    private static partial Regex Axis();

    // Runs from a line up to RTS; false at the end of the program.
    private bool Run(int from, Dictionary<string, double> names)
    {
        for (var i = from; i < _lines.Length && _plain.Count < MostBlocks; i++)
        {
            var line = Comment().Replace(_lines[i], "").Trim();
            if (line.StartsWith('$') || line.StartsWith('%'))
            {
                continue;
            }

            if (Label().Match(line) is { Success: true } label)
            {
                line = line[label.Length..];
            }

            if (line == "RTS")
            {
                return true;
            }

            if (Condition().Match(line) is { Success: true } condition)
            {
                i = Holds(condition, names) ? LineOf(condition.Groups["to"].Value) - 1 : i;
            }
            else if (line.StartsWith("GOTO ", StringComparison.Ordinal))
            {
                i = LineOf(line[5..]) - 1;
            }
            else if (line.StartsWith("CALL ", StringComparison.Ordinal))
            {
                var (first, passes, arguments) = Called(line, names);
                for (var pass = 0; pass < passes; pass++)
                {
                    if (!Run(first, new(arguments)))
                    {
                        return false;
                    }
                }
            }
            else if (line.StartsWith("MODIN ", StringComparison.Ordinal))
            {
                var (first, _, arguments) = Called(line, names);
                _modal = (first, arguments);
            }
            else if (line == "MODOUT")
            {
                _modal = null;
            }
            else if (line.Length > 0 && !Plain(line, names))
            {
                return false;
            }
        }

        return false;
    }

    private bool Plain(string line, Dictionary<string, double> names)
    {
        var words = Assignment().Replace(line, m =>
        {
            var name = m.Groups["name"].Value;
            (name.StartsWith("VC", StringComparison.Ordinal) ? _common : names)[name] = Compute(m.Groups["value"].Value, names);
            return "";
        });
        words = Word().Replace(words, m => m.Groups["letter"].Value
            + Math.Round(Compute(m.Groups["value"].Value, names), 9).ToString("0.0########", CultureInfo.InvariantCulture));
        if (words.Trim().Length > 0)
        {
            _plain.Add(words.Trim());
        }

        if (words.Contains("M30", StringComparison.Ordinal))
        {
            return false;
        }

        if (_modal is not { } modal || !Axis().IsMatch(words))
        {
            return true;
        }

        _modal = null;
        var goesOn = Run(modal.First, new(modal.Names));
        _modal = modal;
        return goesOn;
    }

    private (int First, int Passes, Dictionary<string, double> Arguments) Called(string line, Dictionary<string, double> names)
    {
        var words = line.Split(' ', StringSplitOptions.RemoveEmptyEntries);
        var (passes, arguments) = (1, new Dictionary<string, double>());
        foreach (var word in words[2..])
        {
            if (word.Split('=') is [var name, var value])
            {
                arguments[name] = Compute(value, names);
            }
            else
            {
                passes = int.Parse(word[1..], CultureInfo.InvariantCulture);
            }
        }

        return (LineOf(words[1]) + 1, passes, arguments);
    }

    private int LineOf(string label) => Array.FindIndex(_lines, l => l.Split(' ')[0] == label) is >= 0 and var at ? at
        : throw new RefereeException($"no {label} here");

    private bool Holds(Match condition, Dictionary<string, double> names)
    {
        var sign = Compute(condition.Groups["a"].Value, names).CompareTo(Compute(condition.Groups["b"].Value, names));
        return condition.Groups["what"].Value switch
        {
            "EQ" => sign == 0,
            "NE" => sign != 0,
            "LT" => sign < 0,
            "LE" => sign <= 0,
            "GT" => sign > 0,
            _ => sign >= 0,
        };
    }

    // A formula without spaces: sums of products of numbers, names, brackets and SIN or COS.
    private double Compute(string formula, Dictionary<string, double> names)
    {
        var at = 0;
        var value = Sum(formula, ref at, names);
        return at == formula.Length ? value : throw new RefereeException($"'{formula[at..]}' is not read");
    }

    private double Sum(string text, ref int at, Dictionary<string, double> names)
    {
        var value = Product(text, ref at, names);
        while (at < text.Length && text[at] is '+' or '-')
        {
            value += text[at++] == '+' ? Product(text, ref at, names) : -Product(text, ref at, names);
        }

        return value;
    }

    private double Product(string text, ref int at, Dictionary<string, double> names)
    {
        var value = Operand(text, ref at, names);
        while (at < text.Length && text[at] is '*' or '/')
        {
            value = text[at++] == '*' ? value * Operand(text, ref at, names) : value / Operand(text, ref at, names);
        }

        return value;
    }

    private double Operand(string text, ref int at, Dictionary<string, double> names)
    {
        if (text[at] is '-' or '+')
        {
            return text[at++] == '-' ? -Operand(text, ref at, names) : Operand(text, ref at, names);
        }

        if (text[at] == '[')
        {
            at++;
            var inner = Sum(text, ref at, names);
            at++;
            return inner;
        }

        var spelled = new StringBuilder();
        while (at < text.Length && (char.IsAsciiLetterOrDigit(text[at]) || text[at] == '.'))
        {
            spelled.Append(text[at++]);
        }

        var name = spelled.ToString();
        return name is "SIN" or "COS" ? Turned(name, Operand(text, ref at, names) * Math.PI / 180)
            : double.TryParse(name, NumberStyles.AllowDecimalPoint, CultureInfo.InvariantCulture, out var number) ? number
            : (name.StartsWith("VC", StringComparison.Ordinal) ? _common : names)[name];
    }

    private static double Turned(string name, double angle) => name == "SIN" ? Math.Sin(angle) : Math.Cos(angle);
}

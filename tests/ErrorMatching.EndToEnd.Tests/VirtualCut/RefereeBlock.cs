using System.Globalization;

namespace ErrorMatching.EndToEnd.Tests;

/// <summary>The words of one line, comments and block skip taken off.</summary>
internal sealed class RefereeBlock
{
    private readonly List<(char Letter, double Value)> _words = [];

    private RefereeBlock(int line) => Line = line;

    public int Line { get; }

    public string Number { get; private set; } = "";

    /// <summary>The G words of the block, 54.1 as 54.1.</summary>
    public IEnumerable<double> Preparatory => _words.Where(w => w.Letter == 'G').Select(w => w.Value);

    public IEnumerable<double> Miscellaneous => _words.Where(w => w.Letter == 'M').Select(w => w.Value);

    public IEnumerable<char> Letters => _words.Select(w => w.Letter);

    public bool Has(char letter) => _words.Exists(w => w.Letter == letter);

    public double? Value(char letter) => Has(letter) ? _words.Find(w => w.Letter == letter).Value : null;

    public static RefereeBlock Read(string text, int line)
    {
        var block = new RefereeBlock(line);
        for (var at = 0; at < text.Length;)
        {
            var letter = char.ToUpperInvariant(text[at]);
            if (letter == '(')
            {
                var close = text.IndexOf(')', at);
                at = close < 0 ? throw new RefereeException($"line {line}: a comment without end") : close + 1;
            }
            else if (letter == ';')
            {
                break;
            }
            else if (char.IsWhiteSpace(letter) || letter is '%' or '/')
            {
                at++;
            }
            else
            {
                at = block.ReadWord(text, at, letter);
            }
        }

        return block;
    }

    private int ReadWord(string text, int at, char letter)
    {
        var end = at + 1;
        while (end < text.Length && (char.IsAsciiDigit(text[end]) || text[end] is '.' or '-' or '+'))
        {
            end++;
        }

        var spelled = text[(at + 1)..end];
        if (!char.IsAsciiLetter(letter) || !double.TryParse(spelled, NumberStyles.Float, CultureInfo.InvariantCulture, out var value))
        {
            throw new RefereeException($"line {Line}: '{text[at..]}' is not a word");
        }

        if (letter == 'N')
        {
            Number = "N" + spelled;
        }
        else if ("GM".Contains(letter))
        {
            _words.Add((letter, value));
        }
        else if (Has(letter))
        {
            throw new RefereeException($"line {Line}: two {letter} words");
        }
        else
        {
            _words.Add((letter, value));
        }

        return end;
    }
}

using System.Text;
using ErrorMatching.Nc;

namespace ErrorMatching.Freeform;

/// <summary>Words of a job as a comment of a control may contain them. Letters with accents, Greek and Cyrillic letters are written in
/// Latin ones; what the control does not know becomes a hyphen.</summary>
/// <param name="dialect">The control.</param>
internal sealed class CommentText(NcDialect dialect)
{
    private const char Unknown = '-';

    /// <summary>Characters that are taken of a name.</summary>
    public const int MostOfName = 80;

    // The signs of ISO 840, the code of punched tape, without those that begin or end something.
    private const string CapitalSigns = " .,+-/=";

    // What ends a comment or a text, begins another one, or begins or ends a program; what grbl obeys wherever it stands (~ goes on,
    // ! holds, ? asks; grbl 1.1, Realtime Commands).
    private const string Ending = "(){}[];\"%~!?";

    // LinuxCNC executes comments that begin so (LinuxCNC 2.9, Comments).
    private static readonly string[] Executed =
        [
            "MSG,", "DEBUG,", "PRINT,", "LOG,", "LOGOPEN,", "LOGAPPEND,", "LOGCLOSE", "PROBEOPEN", "PROBECLOSE", "ABORT,", "PY,", "PYRUN,"];

    // Umlauts as in German.
    private const string Latin =
        "À=A Á=A Â=A Ã=A Å=A Ā=A Ă=A Ą=A Ä=AE Æ=AE Ç=C Ć=C Ĉ=C Ċ=C Č=C Ð=D Ď=D Đ=D È=E É=E Ê=E Ë=E Ē=E Ĕ=E Ė=E Ę=E Ě=E Ĝ=G Ğ=G Ġ=G Ģ=G "
            + "Ĥ=H Ħ=H Ì=I Í=I Î=I Ï=I Ĩ=I Ī=I Ĭ=I Į=I Ĵ=J Ķ=K Ĺ=L Ļ=L Ľ=L Ł=L Ñ=N Ń=N Ņ=N Ň=N Ò=O Ó=O Ô=O Õ=O Ø=O Ō=O Ŏ=O Ő=O Ö=OE Œ=OE "
            + "Ŕ=R Ŗ=R Ř=R Ś=S Ŝ=S Ş=S Š=S Ș=S ẞ=SS Ţ=T Ť=T Ŧ=T Ț=T Þ=TH Ù=U Ú=U Û=U Ũ=U Ū=U Ŭ=U Ů=U Ű=U Ų=U Ü=UE Ŵ=W Ý=Y Ŷ=Y Ÿ=Y "
            + "Ź=Z Ż=Z Ž=Z";

    private const string Greek =
        "Α=A Ά=A Β=V Γ=G Δ=D Ε=E Έ=E Ζ=Z Η=I Ή=I Θ=TH Ι=I Ί=I Κ=K Λ=L Μ=M Ν=N Ξ=X Ο=O Ό=O Π=P Ρ=R Σ=S Τ=T Υ=Y Ύ=Y Φ=F Χ=CH Ψ=PS Ω=O Ώ=O";

    // As in passports (ICAO 9303, part 3).
    private const string Cyrillic =
        "А=A Б=B В=V Г=G Д=D Е=E Ё=E Ж=ZH З=Z И=I Й=I К=K Л=L М=M Н=N О=O П=P Р=R С=S Т=T У=U Ф=F Х=KH Ц=TS Ч=CH Ш=SH Щ=SHCH Ъ=IE Ы=Y "
            + "Ь= Э=E Ю=IU Я=IA";

    private const string Signs = "İ=I ı=i ς=s µ=u °=deg ±=+/- ×=x ⌀=D …=... “=' ”=' „=' ‘=' ’=' –=- —=-";

    private static readonly Dictionary<char, string> Spelling = Spellings();

    /// <summary>The text as part of a comment.</summary>
    public string Of(string text)
    {
        var result = new StringBuilder();
        foreach (var c in text.Take(MostOfName))
        {
            foreach (var letter in Spelled(c))
            {
                result.Append(Allowed(dialect.CommentCapitals ? char.ToUpperInvariant(letter) : letter));
            }
        }

        var words = result.ToString().Trim();
        return dialect.Syntax == NcSyntax.LinuxCnc && IsExecuted(words) ? $"{Unknown} {words}" : words;
    }

    /// <summary>A line of the program. A comment that is too long is cut, inside of what encloses it.</summary>
    public string Line(string line)
    {
        var start = dialect.Syntax == NcSyntax.Siemens || !dialect.HasCodes
            ? line.StartsWith(';') ? 0 : line.Length
            : line.EndsWith(')') ? line.LastIndexOf('(') : line.Length;
        var over = line.Length - start - dialect.CommentLength;
        return over <= 0 || start < 0 ? line
            : line[start] == '(' ? line[..^(over + 1)].TrimEnd() + ")"
            : line[..^over].TrimEnd();
    }

    private static bool IsExecuted(string words)
    {
        var dense = words.Replace(" ", "", StringComparison.Ordinal);
        return Executed.Any(e => dense.StartsWith(e, StringComparison.OrdinalIgnoreCase));
    }

    private static string Spelled(char c) => c switch
    {
        // Accents that stand on their own.
        >= '\u0300' and <= '\u036F' => "",

        // Full-width forms.
        >= '\uFF01' and <= '\uFF5E' => ((char)(c - 0xFEE0)).ToString(),
        _ => Spelling.GetValueOrDefault(c) ?? c.ToString(),
    };

    private char Allowed(char c)
    {
        var isAllowed = dialect.CommentCapitals
            ? char.IsAsciiLetterUpper(c) || char.IsAsciiDigit(c) || CapitalSigns.Contains(c, StringComparison.Ordinal)
            : c is >= ' ' and <= '~' && !Ending.Contains(c, StringComparison.Ordinal);
        return isAllowed ? c : Unknown;
    }

    private static Dictionary<char, string> Spellings()
    {
        var spellings = new Dictionary<char, string>();
        foreach (var pair in $"{Latin} {Greek} {Cyrillic}".Split(' '))
        {
            spellings[char.ToLowerInvariant(pair[0])] = pair[2..].ToLowerInvariant();
            spellings[pair[0]] = pair[2..];
        }

        foreach (var pair in Signs.Split(' '))
        {
            spellings[pair[0]] = pair[2..];
        }

        return spellings;
    }
}

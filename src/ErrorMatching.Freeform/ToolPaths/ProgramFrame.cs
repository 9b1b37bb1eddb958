using System.Text;
using ErrorMatching.Nc;

namespace ErrorMatching.Freeform;

/// <summary>What stands before and behind the moves of a program, as data: one text for each built-in dialect, with values in braces and one line <c>{path}</c> for the moves.</summary>
internal sealed record ProgramFrame(string Before, string Behind)
{
    private const string Moves = "{path}\n";

    /// <summary>The frame for a dialect: its own, or for a shop's dialect that of the control that spells alike.</summary>
    public static ProgramFrame Of(NcDialect dialect)
    {
        var name = NcDialects.Names.Contains(dialect.Name) ? dialect.Name : dialect.Syntax switch
        {
            NcSyntax.Siemens => NcDialects.Siemens840D.Name,
            NcSyntax.LinuxCnc => NcDialects.LinuxCnc.Name,
            _ => NcDialects.Generic.Name,
        };
        using var stream = typeof(ProgramFrame).Assembly.GetManifestResourceStream(name + ".frame")!;
        using var reader = new StreamReader(stream, Encoding.ASCII);
        var text = reader.ReadToEnd();
        var at = text.IndexOf(Moves, StringComparison.Ordinal);
        return new(text[..at], text[(at + Moves.Length)..]);
    }

    /// <summary>A text with its values. What a value may not hold in a comment (anything but plain letters, a parenthesis, a line end) is replaced.</summary>
    public static byte[] Fill(string text, IEnumerable<KeyValuePair<string, string>> values)
    {
        foreach (var (key, value) in values)
        {
            text = text.Replace("{" + key + "}", Plain(value), StringComparison.Ordinal);
        }

        return Encoding.ASCII.GetBytes(text);
    }

    private static string Plain(string value) => string.Concat(value.Take(80).Select(c => c switch
    {
        '(' or '{' => '[',
        ')' or '}' => ']',
        >= ' ' and <= '~' and not '%' and not ';' => c,
        _ => '?',
    }));
}

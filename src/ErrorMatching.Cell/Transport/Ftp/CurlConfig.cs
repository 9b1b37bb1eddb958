using System.Text;

namespace ErrorMatching.Cell;

/// <summary>Input for curl in the format of its configuration files. curl reads it from standard input, so that no password is on a command
/// line.</summary>
internal sealed class CurlConfig
{
    private readonly StringBuilder _text = new();

    /// <summary>Adds an option without a value.</summary>
    public CurlConfig Set(string option)
    {
        _text.Append(option).Append('\n');
        return this;
    }

    /// <summary>Adds an option with any value.</summary>
    public CurlConfig Set(string option, string value)
    {
        _text.Append(option).Append(" = \"");
        foreach (var c in value)
        {
            // A line end terminates a value even inside quotes, and a backslash starts one of curl's escapes.
            _ = c switch
            {
                '\\' => _text.Append(@"\\"),
                '"' => _text.Append("\\\""),
                '\n' => _text.Append(@"\n"),
                '\r' => _text.Append(@"\r"),
                '\t' => _text.Append(@"\t"),
                '\v' => _text.Append(@"\v"),
                _ => _text.Append(c),
            };
        }

        _text.Append("\"\n");
        return this;
    }

    /// <summary>The configuration as curl reads it.</summary>
    public byte[] ToBytes() => Encoding.UTF8.GetBytes(_text.ToString());
}

using System.Text;

namespace ErrorMatching.Reporting;

/// <summary>Writes markup that is both HTML and well-formed XML. All text and attributes are escaped.</summary>
public sealed class HtmlText
{
    private readonly StringBuilder _text = new("<!DOCTYPE html>\n");

    /// <summary>Opens an element; disposing of the result closes it. Attributes without a value are omitted.</summary>
    public HtmlScope In(string element, params ReadOnlySpan<(string Name, string? Value)> attributes)
    {
        Start(element, attributes);
        _text.Append('>');
        return new(this, element);
    }

    /// <summary>Writes an element that contains only text.</summary>
    public void Put(string element, string content, params ReadOnlySpan<(string Name, string? Value)> attributes)
    {
        using (In(element, attributes))
        {
            Text(content);
        }
    }

    /// <summary>Writes an empty element.</summary>
    public void Empty(string element, params ReadOnlySpan<(string Name, string? Value)> attributes)
    {
        Start(element, attributes);
        _text.Append(" />");
        EndLineAfter(element);
    }

    /// <summary>Writes text.</summary>
    public void Text(ReadOnlySpan<char> content) => HtmlEscape.Append(_text, content);

    /// <summary>Writes the style sheet, which must not contain markup characters.</summary>
    public void Style(string css) => _text.Append("<style>\n").Append(css).Append("</style>\n");

    /// <summary>Returns UTF-8 without a byte order mark.</summary>
    public byte[] ToBytes()
    {
        // Piece by piece: a page may have megabytes, which need not be copied once more as one text.
        using var bytes = new MemoryStream(_text.Length + (_text.Length / 16));
        using (var writer = new StreamWriter(bytes, new UTF8Encoding(encoderShouldEmitUTF8Identifier: false), leaveOpen: true))
        {
            foreach (var piece in _text.GetChunks())
            {
                writer.Write(piece.Span);
            }
        }

        return bytes.ToArray();
    }

    internal void End(string element)
    {
        _text.Append("</").Append(element).Append('>');
        EndLineAfter(element);
    }

    private void Start(string element, ReadOnlySpan<(string Name, string? Value)> attributes)
    {
        _text.Append('<').Append(element);
        foreach (var (name, value) in attributes)
        {
            if (value is not null)
            {
                _text.Append(' ').Append(name).Append("=\"");
                HtmlEscape.Append(_text, value);
                _text.Append('"');
            }
        }
    }

    // A line end between blocks is visible only in the source. Within a sentence or a program block, it would be a space.
    private void EndLineAfter(string element)
    {
        if (element is not ("a" or "code" or "del" or "em" or "ins" or "span" or "strong" or "title" or "tspan"))
        {
            _text.Append('\n');
        }
    }
}

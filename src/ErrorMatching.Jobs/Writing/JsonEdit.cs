using System.Text;
using System.Text.Encodings.Web;
using System.Text.Json;

namespace ErrorMatching.Jobs;

/// <summary>A change to a JSON document that keeps all other bytes.</summary>
/// <param name="At">The bytes to replace.</param>
/// <param name="With">The replacement.</param>
internal sealed record JsonEdit(Range At, string With)
{
    /// <summary>Applies edits that do not overlap.</summary>
    public static byte[] Apply(ReadOnlySpan<byte> document, IEnumerable<JsonEdit> edits)
    {
        using var changed = new MemoryStream();
        var at = 0;
        foreach (var edit in edits.OrderBy(e => e.At.Start.Value))
        {
            changed.Write(document[at..edit.At.Start.Value]);
            changed.Write(Encoding.UTF8.GetBytes(edit.With));
            at = edit.At.End.Value;
        }

        changed.Write(document[at..]);
        return changed.ToArray();
    }

    /// <summary>A text as JSON.</summary>
    public static string Text(string text) => $"\"{JsonEncodedText.Encode(text, JavaScriptEncoder.UnsafeRelaxedJsonEscaping)}\"";

    /// <summary>A list of texts as JSON.</summary>
    public static string List(IEnumerable<string> texts) => "[" + string.Join(", ", texts.Select(Text)) + "]";
}

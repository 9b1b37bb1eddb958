using System.Text;
using System.Text.Encodings.Web;
using System.Text.Json;
using System.Text.Json.Nodes;

namespace ErrorMatching.Jobs;

/// <summary>Writes a draft as a job. Text that is not a number is written as text, so that the job's reader reports it with its
/// place.</summary>
internal static class DraftWriter
{
    private static readonly JsonSerializerOptions Plain = new() { Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping };

    /// <summary>The job's file, with one line per key and one per feature.</summary>
    public static byte[] Job(MatingDraft draft) => Encoding.UTF8.GetBytes(
        "{\n" + string.Join(",\n", draft.Write().Select(m => $"  {JsonEdit.Text(m.Key)}: {Value(m.Value)}")) + "\n}\n");

    private static string Value(JsonNode? value) => value is JsonArray { Count: > 0 } list && list[0] is JsonObject
        ? "[\n" + string.Join(",\n", list.Select(i => "    " + OneLine(i))) + "\n  ]"
        : OneLine(value);

    private static string OneLine(JsonNode? value) => value switch
    {
        null => "null",
        JsonObject { Count: 0 } => "{}",
        JsonObject o => "{ " + string.Join(", ", o.Select(m => $"{JsonEdit.Text(m.Key)}: {OneLine(m.Value)}")) + " }",
        JsonArray a => "[" + string.Join(", ", a.Select(OneLine)) + "]",
        _ => value.ToJsonString(Plain),
    };
}

using System.Text.Json;
using System.Text.Json.Serialization;

namespace ErrorMatching.Jobs;

/// <summary>How drafts stand in the files that keep them.</summary>
internal static class DraftJson
{
    /// <summary>Words for kinds; nothing that must be there is null.</summary>
    public static JsonSerializerOptions Options { get; } = new() { Converters = { new JsonStringEnumConverter() }, RespectNullableAnnotations = true };
}

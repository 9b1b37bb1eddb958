using System.Text.Json;
using System.Text.Json.Serialization;
using ErrorMatching.Mating;

namespace ErrorMatching.Jobs;

/// <summary>The format of stored drafts.</summary>
internal static class DraftJson
{
    /// <summary>Writes kinds as words; required values must not be null.</summary>
    public static JsonSerializerOptions Options { get; } = new()
    {
        Converters = { new JsonStringEnumConverter(), new KindConverter() },
        RespectNullableAnnotations = true
    };

    private sealed class KindConverter : JsonConverter<FeatureKind>
    {
        public override FeatureKind Read(ref Utf8JsonReader reader, Type typeToConvert, JsonSerializerOptions options) =>
            reader.TokenType == JsonTokenType.String && FeatureKinds.Find(reader.GetString()!) is { } kind
                ? kind
                : throw new JsonException("A feature has no kind that there is.");

        public override void Write(Utf8JsonWriter writer, FeatureKind value, JsonSerializerOptions options) =>
            writer.WriteStringValue(value.Word);
    }
}

using System.Diagnostics.CodeAnalysis;
using System.Text.Json;
using System.Text.Json.Serialization;
using ErrorMatching.Mating;

namespace ErrorMatching.Jobs;

/// <summary>The format of stored drafts, made while the program is compiled: kinds are words, and required values must not be
/// null.</summary>
[JsonSourceGenerationOptions(
    UseStringEnumConverter = true, RespectNullableAnnotations = true, Converters = [typeof(DraftJson.KindConverter)])]
[JsonSerializable(typeof(StoredDraft))]
[SuppressMessage("ApiDesign", "RS0030", Justification = "The generated code names a type without a culture.")]
internal sealed partial class DraftJson : JsonSerializerContext
{
    internal sealed class KindConverter : JsonConverter<FeatureKind>
    {
        public override FeatureKind Read(ref Utf8JsonReader reader, Type typeToConvert, JsonSerializerOptions options) =>
            reader.TokenType == JsonTokenType.String && FeatureKinds.Find(reader.GetString()!) is { } kind
                ? kind
                : throw new JsonException("A feature has no kind that there is.");

        public override void Write(Utf8JsonWriter writer, FeatureKind value, JsonSerializerOptions options) =>
            writer.WriteStringValue(value.Word);
    }
}

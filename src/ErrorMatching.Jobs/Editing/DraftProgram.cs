using System.Text.Json.Serialization;
using ErrorMatching.Json;

namespace ErrorMatching.Jobs;

/// <summary>A program imported into a draft.</summary>
public sealed record DraftProgram
{
    /// <summary>SHA-256 of its bytes as 64 lower-case hexadecimal digits.</summary>
    public required string Sha256 { get; init; }

    /// <summary>Its bytes.</summary>
    [JsonIgnore]
    public ReadOnlyMemory<byte> Bytes { get; init; }

    /// <summary>Creates it from the program's bytes.</summary>
    public static DraftProgram Of(ReadOnlyMemory<byte> bytes) =>
        new() { Sha256 = ContentHash.Sha256(bytes.Span), Bytes = bytes };
}

using System.Text.Json;
using ErrorMatching.Freeform;
using ErrorMatching.Geometry;

namespace ErrorMatching.Hmi;

/// <summary>The stored report of a compensated surface (<c>errormatch/surface-compensate/1</c> and
/// <c>errormatch/surface-displace/1</c>): the same numbers as the console's, read and not recomputed.</summary>
public sealed record KeptSurface
{
    private static readonly string[] Schemas = ["errormatch/surface-compensate/1", "errormatch/surface-displace/1"];

    public required string JobName { get; init; }

    /// <summary>True if it was measured after finishing, false after semi-finishing.</summary>
    public required bool IsFinished { get; init; }

    /// <summary>True if each place is moved by its own error, false if all by the mean error, as with a modified tool radius.</summary>
    public required bool IsMirror { get; init; }

    /// <summary>The share of the error that is compensated.</summary>
    public required double Gain { get; init; }

    /// <summary>The largest distance of the compensated surface from the nominal one, in mm.</summary>
    public required double LargestMoveMm { get; init; }

    /// <summary>True if neighboring errors are similar, false if they look like noise, null if this cannot be determined.</summary>
    public required bool? IsSystematic { get; init; }

    /// <summary>Statistics of the measured errors.</summary>
    public required DeviationStatistics Before { get; init; }

    /// <summary>Errors expected to remain after mirroring.</summary>
    public required DeviationStatistics Mirror { get; init; }

    /// <summary>Errors expected to remain with a modified tool radius.</summary>
    public required DeviationStatistics ToolRadius { get; init; }

    /// <summary>Standard uncertainty of the expected error at a point, in mm.</summary>
    public required double PointUncertaintyMm { get; init; }

    /// <summary>The measured points in the order of measuring.</summary>
    public required IReadOnlyList<KeptSurfacePoint> Points { get; init; }

    /// <summary>Map of the error, and of what remains of it.</summary>
    public required ErrorMap Map { get; init; }

    /// <summary>The generated tool path; null if an existing program was displaced.</summary>
    public required KeptToolPath? ToolPath { get; init; }

    /// <summary>The proof of the displaced program; null if the program was generated.</summary>
    public required KeptProof? Proof { get; init; }

    /// <summary>True if the program calls its tool, false if it stops with an alarm instead; null if the report does not say,
    /// because it is old or an existing program was displaced.</summary>
    public required bool? CallsTool { get; init; }

    /// <summary>What the user should know before using the program. A missing tool call is reported by <see cref="CallsTool"/>.</summary>
    public required IReadOnlyList<string> Warnings { get; init; }

    /// <summary>Errors expected to remain after the chosen compensation.</summary>
    public DeviationStatistics Expected => IsMirror ? Mirror : ToolRadius;

    /// <summary>Reads a report.</summary>
    /// <returns>The report; null if it is of another kind, or too old to have a map.</returns>
    public static KeptSurface? Read(ReadOnlyMemory<byte> json)
    {
        using var document = JsonDocument.Parse(json);
        var root = document.RootElement;
        if (!Schemas.Contains(root.GetProperty("schema").GetString(), StringComparer.Ordinal) || !root.TryGetProperty("map", out var map))
        {
            return null;
        }

        var (compensation, predicted, job) = (root.GetProperty("compensation"), root.GetProperty("predicted"), root.GetProperty("job"));
        bool? callsTool = root.GetProperty("program") is { ValueKind: JsonValueKind.Object } program
            && program.TryGetProperty("toolCall", out var calls)
            ? calls.GetBoolean()
            : null;
        return new()
        {
            JobName = (job.ValueKind == JsonValueKind.String ? job : job.GetProperty("name")).GetString()!,
            IsFinished = root.GetProperty("stage").GetString() == "finishing",
            IsMirror = compensation.GetProperty("method").GetString() == "mirror",
            Gain = compensation.GetProperty("gain").GetDouble(),
            LargestMoveMm = Millimeters(compensation, "largestMoveUm"),
            IsSystematic = root.GetProperty("structure").GetProperty("verdict").GetString() switch
            {
                "systematic" => true,
                "noise" => false,
                _ => null
            },
            Before = Statistics(root.GetProperty("before")),
            Mirror = Statistics(predicted.GetProperty("mirror")),
            ToolRadius = Statistics(predicted.GetProperty("toolRadius")),
            PointUncertaintyMm = Millimeters(predicted.GetProperty("mirror"), "pointUncertaintyUm"),
            Points = [.. root.GetProperty("points").EnumerateArray().Select(KeptSurfacePoint.Read)],
            Map = ReadMap(map),
            ToolPath = root.TryGetProperty("toolpath", out var path) ? KeptToolPath.Read(path) : null,
            Proof = root.TryGetProperty("proof", out var proof) ? KeptProof.Read(proof) : null,
            CallsTool = callsTool,

            // A missing tool call is the first warning.
            Warnings = [.. root.GetProperty("warnings").EnumerateArray().Select(w => w.GetString()!).Skip(callsTool == false ? 1 : 0)],
        };
    }

    /// <summary>A length stored in micrometers, in mm.</summary>
    internal static double Millimeters(JsonElement json, string name) => json.GetProperty(name).GetDouble() / 1000;

    private static DeviationStatistics Statistics(JsonElement json) => new(
        json.GetProperty("count").GetInt32(),
        Millimeters(json, "meanUm"),
        Millimeters(json, "standardDeviationUm"),
        Millimeters(json, "profileIsoUm"),
        Millimeters(json, "profileRangeUm"));

    private static ErrorMap ReadMap(JsonElement json)
    {
        double[] Numbers(string name) => [.. json.GetProperty(name).EnumerateArray().Select(v => v.GetDouble())];
        double[] InMm(string name) => Array.ConvertAll(Numbers(name), um => um / 1000);
        return new(
            new(
                json.GetProperty("countU").GetInt32(),
                json.GetProperty("countV").GetInt32(),
                [.. Numbers("x").Zip(Numbers("y"), (x, y) => new Point3(x, y, 0))],
                [.. Numbers("outside").Select(c => (int)c)]),
            InMm("errorUm"),
            InMm("mirrorUm"),
            InMm("toolRadiusUm"));
    }
}

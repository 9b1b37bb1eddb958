using ErrorMatching.Freeform;
using ErrorMatching.Jobs;
using ErrorMatching.Mating;
using ErrorMatching.Refusals;
using ErrorMatching.Reporting;

namespace ErrorMatching.Hmi;

/// <summary>A report in the store: the same numbers as the console's, read and not recomputed.</summary>
internal sealed record StoredReport
{
    private static readonly StoredReport Other = new();

    /// <summary>The report of a match; null if it is of another kind.</summary>
    public MatchReport? Match { get; private init; }

    /// <summary>The report of a verification; null if it is of another kind.</summary>
    public VerifyReport? Verification { get; private init; }

    /// <summary>The report of a compensated surface; null if it is of another kind, or too old to have a map.</summary>
    public StoredSurface? Surface { get; private init; }

    /// <summary>Reads a report.</summary>
    /// <exception cref="InputException">A member is missing or wrong.</exception>
    public static StoredReport Read(ReadOnlySpan<byte> json)
    {
        var document = ReportReader.Document(json);
        return document.Schema switch
        {
            MatchReportJson.Schema => new() { Match = MatchReportJson.Read(document) },
            VerifyReportJson.Schema => new() { Verification = VerifyReportJson.Read(document) },
            CompensationDocument.Schema => new() { Surface = StoredSurface.Of(CompensationDocument.Read(document)) },
            DisplacementDocument.Schema => new() { Surface = StoredSurface.Of(DisplacementDocument.Read(document)) },
            _ => Other,
        };
    }
}

using System.Text.Json;

namespace ErrorMatching.Hmi;

/// <summary>The stored report of a match (<c>errormatch/match/1</c>): the same numbers as the console's <c>report.json</c>, read
/// and not recomputed.</summary>
/// <param name="JobName">Name of the job.</param>
/// <param name="WorkOrder">The job's work order; null if it states none.</param>
/// <param name="Features">The features in the order of cutting.</param>
/// <param name="Points">The key points in the order of cutting.</param>
/// <param name="Blocks">The blocks that differ.</param>
/// <param name="ChangedBlocks">Number of blocks that differ.</param>
/// <param name="Proof">What was proved about the program.</param>
/// <param name="FollowsWhole">True if the counterpart follows the whole deviation, false for only the part beyond the limit.</param>
/// <param name="Warnings">What the user should know before using the program.</param>
public sealed record KeptReport(
    string JobName,
    string? WorkOrder,
    IReadOnlyList<KeptFeature> Features,
    IReadOnlyList<KeptPoint> Points,
    IReadOnlyList<KeptBlock> Blocks,
    int ChangedBlocks,
    KeptProof Proof,
    bool FollowsWhole,
    IReadOnlyList<KeptWarning> Warnings)
{
    /// <summary>The schema to read.</summary>
    public const string Schema = "errormatch/match/1";

    /// <summary>Reads a report.</summary>
    /// <returns>The report; null if it is of another kind, such as of a surface.</returns>
    public static KeptReport? Read(ReadOnlyMemory<byte> json)
    {
        using var document = JsonDocument.Parse(json);
        var root = document.RootElement;
        if (root.GetProperty("schema").GetString() != Schema)
        {
            return null;
        }

        var (job, program) = (root.GetProperty("job"), root.GetProperty("program"));
        return new(
            job.GetProperty("name").GetString()!,
            job.TryGetProperty("workOrder", out var order) ? order.GetString() : null,
            [.. root.GetProperty("features").EnumerateArray().Select(KeptFeature.Read)],
            [.. root.GetProperty("keyPoints").EnumerateArray().Select(KeptPoint.Read)],
            [.. program.GetProperty("blocks").EnumerateArray().Select(KeptBlock.Read)],
            program.GetProperty("changedBlocks").GetInt32(),
            KeptProof.Read(root.GetProperty("proof")),
            root.GetProperty("compensation").GetProperty("amount").GetString() == "whole",
            KeptWarning.Read(root));
    }
}

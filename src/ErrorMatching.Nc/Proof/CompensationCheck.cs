namespace ErrorMatching.Nc;

/// <summary>Checks that the control can still cut the contour under cutter compensation: the tool must fit into each corner and arc of the
/// result, and its way in must be long enough.</summary>
internal static class CompensationCheck
{
    /// <summary>Adds a failure if the control would stop. If the path of the tool's center in the original is not followed, or the original
    /// is not compensated, that of the result is not judged.</summary>
    public static void Run(ProofTask task, ProofFindings findings)
    {
        if (!CompensatedPath.Concerns(task.Before))
        {
            return;
        }

        var before = CompensatedPath.Check(task.Before);
        if ((before is null ? CompensatedPath.Check(task.After) : CompensatedPath.Stops(before) ? before : null) is { } refusal)
        {
            findings.Add(refusal);
        }
    }
}

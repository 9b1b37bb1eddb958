using ErrorMatching.Mating;
using ErrorMatching.Refusals;
using ErrorMatching.Reporting;

namespace ErrorMatching.Jobs;

/// <summary>Reports a measured counterpart that a job names but that does not exist. This is a warning, because a program can be
/// made without it. But a cell reads the file later to compare the cut piece, and then it is too late.</summary>
public static class MissingMeasured
{
    /// <summary>Where a job names it.</summary>
    public const string Path = "$.counterpart.measured";

    /// <summary>The warning for a report.</summary>
    /// <param name="job">The job.</param>
    /// <returns>The warning; null if the job names no file or the file exists. Also null in feedback, which needs the file: there
    /// it comes with the measurement, or the match reports that it is missing.</returns>
    public static ReportWarning? Of(MatingJob job)
    {
        ArgumentNullException.ThrowIfNull(job);
        return job is { Compensation.From: CompensationSource.Part, Counterpart.Measured: { } file } && !File.Exists(job.PathOf(file))
            ? new(WarningForms.MeasuredNotThere.Name, WarningForms.MeasuredNotThere.With(file), file)
            : null;
    }

    /// <summary>The warning with its place in the job's file; null in the same cases as <see cref="Of"/>.</summary>
    /// <param name="job">The job.</param>
    public static Refusal? ItemOf(MatingJob job) => Of(job) is { } warning && job.MeasuredPlace is { } place
        ? new(warning.Code, warning.Message, new() { File = job.File, Line = place.Line, Column = place.Column, Path = Path })
        : null;
}

using ErrorMatching.Mating;
using ErrorMatching.Reporting;

namespace ErrorMatching.Jobs;

/// <summary>
/// Tells of a measured counterpart that a job names and that is not there. A program is made without it, so it is a warning and no error; but where a cell compares what was cut, it is looked for, and then it is late.
/// </summary>
public static class MissingMeasured
{
    /// <summary>Where a job names it.</summary>
    public const string Path = "$.counterpart.measured";

    /// <summary>The warning, as a report has it.</summary>
    /// <param name="job">The job.</param>
    /// <returns>The warning; null where the job names none, where its file is there, and in feedback, which cannot do without: there it is given with the measurement, or a match says that it is not there.</returns>
    public static ReportWarning? Of(MatingJob job)
    {
        ArgumentNullException.ThrowIfNull(job);
        return job is { Compensation.From: CompensationSource.Part, Counterpart.Measured: { } file } && !File.Exists(job.PathOf(file))
            ? new(WarningForms.MeasuredNotThere.Name, WarningForms.MeasuredNotThere.With(file), file)
            : null;
    }

    /// <summary>The warning with the place in the job's file; null as of <see cref="Of"/>.</summary>
    /// <param name="job">The job.</param>
    public static ErrorItem? ItemOf(MatingJob job) => Of(job) is { } warning && job.MeasuredPlace is { } place
        ? ErrorItems.At(new(job.File, Path, place), warning.Code, warning.Message)
        : null;
}

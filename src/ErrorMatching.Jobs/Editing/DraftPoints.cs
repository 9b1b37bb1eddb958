using ErrorMatching.Mating;
using ErrorMatching.Measurement;
using ErrorMatching.Refusals;

namespace ErrorMatching.Jobs;

/// <summary>Problems with the theoretical points of a draft, found by the reader of their file.</summary>
internal static class DraftPoints
{
    private const string File = "theoretical.csv";

    /// <summary>Reads the points.</summary>
    /// <param name="draft">The draft.</param>
    /// <param name="job">Its job; null while it has problems.</param>
    /// <param name="problems">Receives the problems.</param>
    /// <returns>The points; null while they have problems.</returns>
    public static MeasurementFile? Check(MatingDraft draft, MatingJob? job, List<DraftProblem> problems)
    {
        var points = draft.Points.ToArray();
        if (points.Length == 0)
        {
            // Missing features are already reported.
            return null;
        }

        MeasurementFile file;
        try
        {
            file = MeasurementReader.Read(MatingDraftFiles.Theoretical(points), File, MeasurementFormat.Points);
        }
        catch (InputException e)
        {
            Explain(draft, points, e, problems);
            return null;
        }

        if (job is not null)
        {
            var count = problems.Count;
            Require(file, job.Alignment.Origin, DraftPaths.DatumOrigin, problems);
            Require(file, job.Alignment.Direction, DraftPaths.DatumDirection, problems);
            Require(file, job.OriginCheck?.Point, DraftPaths.OriginPoint, problems);
            if (problems.Count == count)
            {
                Require(file, job.KeyPoints, DraftPaths.Theoretical, problems);
            }
        }

        return file;
    }

    // A reader stops at the first mistake in a file. To find all of them, read each field in a file where everything else is right.
    private static void Explain(MatingDraft draft, PointDraft[] points, InputException whole, List<DraftProblem> problems)
    {
        var (labels, hasZ, count) = (DraftPaths.Labels(draft).ToArray(), points.Any(p => !string.IsNullOrWhiteSpace(p.Z)), problems.Count);
        for (var i = 0; i < points.Length; i++)
        {
            Try(new(points[i].Label, "0", "0"), labels[i], problems);
            Try(new("1", points[i].X, "0"), DraftPaths.Coordinate(labels[i], "x"), problems);
            Try(new("1", "0", points[i].Y), DraftPaths.Coordinate(labels[i], "y"), problems);
            if (hasZ)
            {
                Try(new("1", "0", "0", points[i].Z), DraftPaths.Coordinate(labels[i], "z"), problems);
            }
        }

        if (problems.Count == count)
        {
            // A problem between rows, such as a duplicate label.
            problems.Add(new(
                whole.Place.Line is { } line and >= 2 && line - 2 < labels.Length ? labels[line - 2] : DraftPaths.Theoretical,
                whole.Code,
                whole.Refusals[0].Found,
                whole.Problem));
        }
    }

    private static void Try(PointDraft point, string field, List<DraftProblem> problems)
    {
        try
        {
            _ = MeasurementReader.Read(MatingDraftFiles.Theoretical([point]), File, MeasurementFormat.Points);
        }
        catch (InputException e)
        {
            // The job's reader may have reported the same label.
            if (!problems.Exists(p => p.Field == field))
            {
                problems.Add(new(field, e.Code, e.Refusals[0].Found, e.Problem));
            }
        }
    }

    private static void Require(MeasurementFile file, string? label, string field, List<DraftProblem> problems) =>
        Require(file, label is null ? [] : [label], field, problems);

    private static void Require(MeasurementFile file, IEnumerable<string> labels, string field, List<DraftProblem> problems)
    {
        try
        {
            file.Require(labels);
        }
        catch (InputException e)
        {
            problems.Add(new(field, e.Code, e.Refusals[0].Found, e.Problem));
        }
    }
}

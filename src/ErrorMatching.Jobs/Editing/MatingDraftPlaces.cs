using ErrorMatching.Geometry;
using ErrorMatching.Mating;
using ErrorMatching.Measurement;
using ErrorMatching.Refusals;

namespace ErrorMatching.Jobs;

/// <summary>Computes where the key points of a draft are in its program, as far as the draft defines it, with the readers of its files
/// and the mapping of the job.</summary>
public static class MatingDraftPlaces
{
    private const string File = "theoretical.csv", Label = "1";

    /// <summary>The positions of the features' key points, in the order of cutting. A point without coordinates has none, and none has
    /// one while the frame is wrong.</summary>
    /// <param name="draft">The draft; it may have other problems.</param>
    public static IReadOnlyList<DraftPlace> Find(MatingDraft draft)
    {
        ArgumentNullException.ThrowIfNull(draft);
        var jobs = draft.Features.Select(f => f.Plane)
            .Distinct(StringComparer.Ordinal)
            .ToDictionary(p => p, p => JobOf(draft, p), StringComparer.Ordinal);
        return [
            .. draft.Features.SelectMany(f => f.Points.Select(
                p => jobs[f.Plane] is { } job ? PlaceOf(f, p, job) : null)).OfType<DraftPlace>()];
    }

    // Uses the draft's frame and plane in an otherwise valid job, so that other missing input does not hide the points.
    private static MatingJob? JobOf(MatingDraft draft, string plane)
    {
        var placed = new MatingDraft
        {
            Name = "places",
            Features = [
                FeatureDraft.New(FeatureKinds.All[0], "line", new()) with { Blocks = "N1", Lower = "0", Upper = "0", Plane = plane }],
        };
        placed = placed.With(draft, DraftPaths.Frame)
            .With(DraftPaths.Uncertainty, "0.001")
            .With(DraftPaths.Program, "places.nc")
            .With(DraftPaths.Dialect, "fanuc")
            .With(DraftPaths.ToolDiameter, "1");
        try
        {
            return MatingJob.Parse(MatingDraftFiles.Job(placed), "job.json");
        }
        catch (InputException)
        {
            return null;
        }
    }

    private static DraftPlace? PlaceOf(FeatureDraft feature, PointDraft point, MatingJob job)
    {
        // Most points of a new draft are still empty; skip them without calling the reader.
        if (string.IsNullOrWhiteSpace(point.X) && string.IsNullOrWhiteSpace(point.Y))
        {
            return null;
        }

        try
        {
            var plane = job.Features[0].Plane;
            var read = MeasurementReader.Read(
                MatingDraftFiles.Theoretical([point with { Label = Label }]), File, MeasurementFormat.Points)[Label];
            return new(feature.Name, point.Label, plane, job.Counterpart.PlaceOf(read, plane, File));
        }
        catch (InputException)
        {
            return null;
        }
    }
}

/// <summary>The position of a draft's key point in its program.</summary>
/// <param name="Feature">Name of its feature.</param>
/// <param name="Label">Its label.</param>
/// <param name="Plane">The plane of its feature.</param>
/// <param name="At">Its position in the program, mm, in the axis order of the plane.</param>
public sealed record DraftPlace(string Feature, string Label, CoordinatePlane Plane, Point2 At);

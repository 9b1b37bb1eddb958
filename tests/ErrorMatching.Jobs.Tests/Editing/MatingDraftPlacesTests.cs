using ErrorMatching.Geometry;
using ErrorMatching.Testing;

namespace ErrorMatching.Jobs.Tests;

/// <summary>Key points lie in the program where the frame puts them, as soon as the draft says where.</summary>
public sealed class MatingDraftPlacesTests
{
    [Fact]
    public void Points_of_a_draft_without_blocks_lie_where_the_frame_of_the_job_puts_them()
    {
        var file = Repository.PathTo("samples", "complex-mating", "job.json");
        var draft = MatingDraftFiles.Open(file);
        draft = (draft with { Name = "" })
            .With("$.counterpart.frame.mirror", "x")
            .With("$.counterpart.frame.rotateDeg", "90")
            .With("$.counterpart.frame.translateMm[0]", "5")
            .With("$.counterpart.frame.translateMm[1]", "-2")
            .With("$.counterpart.toolDiameterMm", "");
        draft = draft.WithFeature(0, f => f with { Blocks = "", Lower = "" });
        var places = MatingDraftPlaces.Find(draft);
        Assert.Equal(draft.Features.SelectMany(f => f.Points.Select(p => (f.Name, p.Label))), places.Select(p => (p.Feature, p.Label)));
        Assert.All(places, p => Assert.Equal(CoordinatePlane.XY, p.Plane));

        // (x, y) becomes (-x, y), then (-y, -x).
        Assert.Equal(0, places[0].At.DistanceTo(new(-76.008 + 5, 31.95 - 2)), 1e-9);
    }

    [Fact]
    public void A_point_without_coordinates_has_no_place_and_none_has_one_in_a_wrong_frame()
    {
        var draft = MatingDraftFiles.Open(Repository.PathTo("samples", "complex-mating", "job.json"));
        var missing = draft.WithFeature(0, f => f with { Flanks = [[f.Flanks[0][0] with { Y = "" }, f.Flanks[0][1]]] });
        Assert.Equal(["2", "2a"], MatingDraftPlaces.Find(missing).Take(2).Select(p => p.Label));
        Assert.Empty(MatingDraftPlaces.Find(draft.With("$.counterpart.frame.rotateDeg", "x")));
        var half = draft.With("$.counterpart.frame.translateMm[0]", "5").With("$.counterpart.frame.translateMm[1]", "");
        Assert.Empty(MatingDraftPlaces.Find(half));
        Assert.Empty(MatingDraftPlaces.Find(new()));
    }

    [Fact]
    public void In_another_plane_a_point_lies_in_the_order_of_its_axes()
    {
        var draft = MatingDraftFiles.Open(Repository.PathTo("samples", "complex-mating", "job.json"));
        var turned = draft with
        {
            Features = [draft.Features[0] with { Plane = "ZX", Flanks = [[new("1", "1", "2", "3"), new("2", "1", "2")]] }]
        };
        var place = Assert.Single(MatingDraftPlaces.Find(turned));
        Assert.Equal((CoordinatePlane.ZX, new Point2(3, 1)), (place.Plane, place.At));
    }
}

using ErrorMatching.Geometry;

namespace ErrorMatching.Freeform.Tests;

public sealed class RegionLineTests
{
    [Theory]
    [InlineData(true)]
    [InlineData(false)]
    public void A_line_knows_the_places_of_the_region_as_the_region_does(bool alongU)
    {
        var random = new Random(3);
        for (var trial = 0; trial < 50; trial++)
        {
            var region = new SurfaceRegion(
                [
                    .. Enumerable.Range(0, 1 + (trial % 3)).Select(
                        _ => (IReadOnlyList<Point2>)[
                            .. Enumerable.Range(0, 9).Select(_ => new Point2(random.NextDouble(), random.NextDouble()))])]);
            var at = random.NextDouble();
            var line = new RegionLine(region, alongU, at);
            for (var i = 0; i < 50; i++)
            {
                var t = random.NextDouble();
                Assert.Equal(alongU ? region.Contains(t, at) : region.Contains(at, t), line.IsInside(t));
            }
        }
    }
}

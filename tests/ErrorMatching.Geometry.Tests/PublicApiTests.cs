using ErrorMatching.Testing;

namespace ErrorMatching.Geometry.Tests;

public class PublicApiTests
{
    [Fact]
    public void Public_surface_is_the_one_on_record() => PublicApi.MatchesSnapshot(typeof(Point2).Assembly);
}

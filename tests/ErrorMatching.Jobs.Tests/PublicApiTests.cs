using ErrorMatching.Testing;

namespace ErrorMatching.Jobs.Tests;

public sealed class PublicApiTests
{
    [Fact]
    public void Public_surface_is_the_one_in_the_snapshot() =>
        PublicApi.MatchesSnapshot(System.Reflection.Assembly.Load("ErrorMatching.Jobs"));
}

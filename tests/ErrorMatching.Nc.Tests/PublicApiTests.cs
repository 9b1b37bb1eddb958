using ErrorMatching.Testing;

namespace ErrorMatching.Nc.Tests;

public sealed class PublicApiTests
{
    [Fact]
    public void Public_surface_is_the_one_in_the_snapshot() => PublicApi.MatchesSnapshot(typeof(NcProgram).Assembly);
}

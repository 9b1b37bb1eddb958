using System.Runtime.Versioning;
using ErrorMatching.Refusals;

namespace ErrorMatching.Cell.Tests;

/// <summary>What everybody on the computer may write decides nothing about a machine.</summary>
[UnsupportedOSPlatform("windows")]
public sealed class ForeignWritersTests : IDisposable
{
    private const UnixFileMode Plain = UnixFileMode.UserRead | UnixFileMode.UserWrite | UnixFileMode.GroupRead | UnixFileMode.OtherRead;
    private const UnixFileMode Open = UnixFileMode.UserRead | UnixFileMode.UserWrite | UnixFileMode.UserExecute | UnixFileMode.GroupRead
        | UnixFileMode.GroupExecute | UnixFileMode.OtherRead | UnixFileMode.OtherExecute;

    private readonly CellFolder? _cell;

    public ForeignWritersTests()
    {
        Assert.SkipWhen(OperatingSystem.IsWindows(), "Windows has lists of rights instead.");
        _cell = new();
        foreach (var file in new[] { "theoretical.csv", "counterpart.nc", "part.csv" })
            _cell.Write("jobs/" + file, "1,0,0\n");
        _cell.Write("jobs/cam.nc", "M30\n");
        Directory.CreateDirectory(Path("store"));
        _cell.Write("cell.json", CellFolder.Right);
        foreach (var folder in Directory.EnumerateDirectories(_cell.Folder, "*", SearchOption.AllDirectories).Prepend(_cell.Folder))
            File.SetUnixFileMode(folder, Open);
        foreach (var file in Directory.EnumerateFiles(_cell.Folder, "*", SearchOption.AllDirectories))
            File.SetUnixFileMode(file, Plain);
    }

    public void Dispose() => _cell?.Dispose();

    [Fact]
    public void What_only_its_owner_may_write_is_right()
    {
        Assert.Empty(Refused());
        Assert.DoesNotContain(Read().Warnings, w => w.Code == "writable-by-group");
    }

    [Theory]
    [InlineData("cell.json", "$")]
    [InlineData("jobs/mating.json", "$.jobs[0].job")]
    [InlineData("jobs/counterpart.nc", "$.jobs[0].job")]
    [InlineData("jobs/theoretical.csv", "$.jobs[0].job")]
    [InlineData("jobs/cam.nc", "$.jobs[3].job")]
    [InlineData("jobs", "$.jobs[0].job")]
    [InlineData("store", "$.store.file")]
    [InlineData(".", "$")]
    public void What_everybody_may_write_is_refused_by_name_and_what_a_group_may_write_is_named(string name, string place)
    {
        var path = name == "." ? _cell!.Folder : Path(name);
        var mode = File.GetUnixFileMode(path);
        File.SetUnixFileMode(path, mode | UnixFileMode.OtherWrite);
        var refused = Assert.Single(Refused());
        Assert.Equal(("writable-by-everybody", place), (refused.Code, refused.Place.Path));
        Assert.Contains($"{path}, which everybody on this computer may write", refused.Message, StringComparison.Ordinal);
        Assert.Contains($"chmod o-w {path}", refused.Message, StringComparison.Ordinal);

        File.SetUnixFileMode(path, mode | UnixFileMode.GroupWrite);
        Assert.Empty(Refused());
        var warned = Assert.Single(Read().Warnings, w => w.Code == "writable-by-group");
        Assert.Equal(place, warned.Place.Path);
        Assert.Contains($"chmod g-w {path}", warned.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void A_store_that_everybody_may_write_is_refused()
    {
        File.SetUnixFileMode(_cell!.Write("store/cell.db", ""), Plain | UnixFileMode.OtherWrite);
        Assert.Equal("writable-by-everybody", Assert.Single(Refused()).Code);
    }

    // Nobody replaces a file of another in such a folder, but makes new ones: next to a store they would be its log.
    [Fact]
    public void The_sticky_bit_guards_files_and_not_the_folder_of_a_store()
    {
        File.SetUnixFileMode(Path("jobs"), Open | UnixFileMode.OtherWrite | UnixFileMode.StickyBit);
        Assert.Empty(Refused());
        File.SetUnixFileMode(Path("store"), Open | UnixFileMode.OtherWrite | UnixFileMode.StickyBit);
        Assert.Equal("$.store.file", Assert.Single(Refused()).Place.Path);
    }

    [Fact]
    public void A_link_is_as_good_as_what_it_leads_to()
    {
        Directory.Move(Path("jobs"), Path("shared"));
        File.CreateSymbolicLink(Path("jobs"), "shared");
        Assert.Empty(Refused());
        File.SetUnixFileMode(Path("shared/counterpart.nc"), Plain | UnixFileMode.OtherWrite);
        Assert.Contains(Path("shared/counterpart.nc"), Assert.Single(Refused()).Message, StringComparison.Ordinal);
    }

    // As under the umask 000: it matters only if others get there.
    [Fact]
    public void Behind_a_folder_that_lets_nobody_in_it_does_not_matter()
    {
        foreach (var file in Directory.EnumerateFiles(_cell!.Folder, "*", SearchOption.AllDirectories))
            File.SetUnixFileMode(file, Plain | UnixFileMode.OtherWrite | UnixFileMode.GroupWrite);
        Assert.NotEmpty(Refused());
        File.SetUnixFileMode(_cell.Folder, UnixFileMode.UserRead | UnixFileMode.UserWrite | UnixFileMode.UserExecute);
        Assert.Empty(Refused());
        Assert.DoesNotContain(Read().Warnings, w => w.Code == "writable-by-group");
    }

    private string Path(string name) => _cell!.PathOf(name);

    private CellSettings Read() => CellSettingsReader.Read(Path("cell.json"));

    private IReadOnlyList<Refusal> Refused()
    {
        try
        {
            _ = Read();
            return [];
        }
        catch (InputException e)
        {
            return e.Refusals;
        }
    }
}

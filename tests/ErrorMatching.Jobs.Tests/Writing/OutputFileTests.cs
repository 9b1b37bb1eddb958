using ErrorMatching.Testing;

namespace ErrorMatching.Jobs.Tests;

public sealed class OutputFileTests
{
    [Fact]
    public void A_file_appears_whole_and_alone()
    {
        using var folder = new TemporaryFolder();
        var path = folder[Path.Combine("new", "folder", "out.nc")];
        Write(path, "one");
        Write(path, "two");
        Assert.Equal("two", File.ReadAllText(path));
        Assert.Equal([path], Directory.GetFiles(Path.GetDirectoryName(path)!));
    }

    [Fact]
    public void An_input_is_never_replaced_by_whatever_name()
    {
        using var folder = new TemporaryFolder();
        var input = folder.File("in.nc", "input");
        var link = folder["link.nc"];
        File.CreateSymbolicLink(link, input);
        var folderLink = folder["alias"];
        Directory.CreateSymbolicLink(folderLink, folder.Path);
        foreach (var path in new[]
        {
            input,
            Path.Combine(folder.Path, ".", "x", "..", "in.nc"),
            link,
            Path.Combine(folderLink, "in.nc"),
            Path.GetRelativePath(Directory.GetCurrentDirectory(), input)
        })
        {
            var error = Assert.Throws<OutputException>(() => Write(path, "output", input));
            Assert.Equal("output-is-input", error.Code);
            Assert.Equal("input", File.ReadAllText(input));
        }

        Assert.Throws<OutputException>(() => Write(input, "output", link));
    }

    [Fact]
    public void What_cannot_be_written_is_said_so_and_leaves_nothing()
    {
        using var folder = new TemporaryFolder();
        Directory.CreateDirectory(folder["taken"]);
        var file = folder.File("file", "");
        foreach (var path in new[] { folder["taken"], Path.Combine(file, "below"), folder["a\0b"], "" })
        {
            var error = Assert.Throws<OutputException>(() => Write(path, "x"));
            Assert.Equal("file-unwritable", error.Code);
        }

        Assert.Equal([file], Directory.GetFiles(folder.Path));
    }

    [Fact]
    public void A_cancelled_write_leaves_the_old_file()
    {
        using var folder = new TemporaryFolder();
        var path = folder.File("out.nc", "old");
        Assert.Throws<OperationCanceledException>(() => OutputFile.Write(
            path, "new"u8.ToArray(), [], new CancellationToken(canceled: true)));
        Assert.Equal("old", File.ReadAllText(path));
        Assert.Equal([path], Directory.GetFiles(folder.Path));
    }

    [Fact]
    public void Files_that_belong_together_appear_together_or_not_at_all()
    {
        using var folder = new TemporaryFolder();
        var (first, last) = (folder.File("report.json", "old"), folder["program.nc"]);
        Directory.CreateDirectory(last);
        var token = TestContext.Current.CancellationToken;
        (string, ReadOnlyMemory<byte>)[] files = [(folder["new.html"], "1"u8.ToArray()), (first, "2"u8.ToArray()), (last, "3"u8.ToArray())];
        Assert.Throws<OutputException>(() => OutputFile.WriteAll(files, [], token));
        Assert.Equal("old", File.ReadAllText(first));
        Assert.Equal([first], Directory.GetFiles(folder.Path));

        Directory.Delete(last);
        OutputFile.WriteAll(files, [], token);
        Assert.Equal(["1", "2", "3"], new[] { folder["new.html"], first, last }.Select(File.ReadAllText));
        Assert.Equal(3, Directory.GetFiles(folder.Path).Length);
    }

    [Fact]
    public void Two_outputs_with_one_name_are_refused_before_anything_is_written()
    {
        using var folder = new TemporaryFolder();
        var path = folder["report.json"];
        var error = Assert.Throws<OutputException>(() => OutputFile.WriteAll(
            [(path, "1"u8.ToArray()), (path, "2"u8.ToArray())], [], TestContext.Current.CancellationToken));
        Assert.Equal("output-twice", error.Code);
        Assert.Empty(Directory.GetFiles(folder.Path));
    }

    [Fact]
    public void A_new_file_replaces_none()
    {
        using var folder = new TemporaryFolder();
        var path = folder.File("job.json", "mine");
        var error = Assert.Throws<OutputException>(() => OutputFile.Create(path, "new"u8.ToArray(), TestContext.Current.CancellationToken));
        Assert.Equal("output-exists", error.Code);
        Assert.Equal("mine", File.ReadAllText(path));
    }

    private static void Write(string path, string text, params string[] inputs) =>
        OutputFile.Write(path, System.Text.Encoding.UTF8.GetBytes(text), inputs, TestContext.Current.CancellationToken);
}

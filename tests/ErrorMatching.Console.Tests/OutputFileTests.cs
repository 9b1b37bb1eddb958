namespace ErrorMatching.Console.Tests;

public class OutputFileTests
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
        foreach (var path in new[] { input, Path.Combine(folder.Path, ".", "x", "..", "in.nc"), link, Path.Combine(folderLink, "in.nc"), Path.GetRelativePath(Directory.GetCurrentDirectory(), input) })
        {
            var error = Assert.Throws<OutputException>(() => Write(path, "output", input));
            Assert.True(error.IsInput);
            Assert.Equal(1, (int)FailureOf.Output(error).Exit);
            Assert.Equal("input", File.ReadAllText(input));
        }

        Assert.Throws<OutputException>(() => Write(input, "output", link));
    }

    [Fact]
    public void What_cannot_be_written_is_exit_3_and_leaves_nothing()
    {
        using var folder = new TemporaryFolder();
        Directory.CreateDirectory(folder["taken"]);
        var file = folder.File("file", "");
        foreach (var path in new[] { folder["taken"], Path.Combine(file, "below"), folder["a\0b"], "" })
        {
            var error = Assert.Throws<OutputException>(() => Write(path, "x"));
            Assert.False(error.IsInput);
            Assert.Equal(3, (int)FailureOf.Output(error).Exit);
        }

        Assert.Equal([file], Directory.GetFiles(folder.Path));
    }

    [Fact]
    public void A_cancelled_write_leaves_the_old_file()
    {
        using var folder = new TemporaryFolder();
        var path = folder.File("out.nc", "old");
        Assert.Throws<OperationCanceledException>(() => OutputFile.Write(path, "new"u8, [], new CancellationToken(canceled: true)));
        Assert.Equal("old", File.ReadAllText(path));
        Assert.Equal([path], Directory.GetFiles(folder.Path));
    }

    private static void Write(string path, string text, params string[] inputs) =>
        OutputFile.Write(path, System.Text.Encoding.UTF8.GetBytes(text), inputs, TestContext.Current.CancellationToken);
}

using System.Diagnostics;
using System.Text;

namespace ErrorMatching.Cell.Tests;

public sealed class HostileFileTests
{
    public static TheoryData<string> Names =>
    [
        "new\nline.csv", "tab\t.csv", "\u001b[31mred.csv", "bell\u0007.csv", "quote\".csv", "single'.csv", "$(reboot).csv", "`id`.csv",
        ";rm -rf .csv", "=cmd|' calc'!A0.csv", "-rf.csv", "back\\slash.csv",
        " space .csv", "\u202Egpj.csv", "zero\u200Bwidth.csv", "Zoë.csv", "漢字.csv", "😀.csv", "%s%n.csv", "a:b.csv", "con.csv", "*.csv",
        "?.csv", "{0}.csv", "..csv", "...csv", "\uFFFD.csv",
    ];

    [Theory]
    [MemberData(nameof(Names))]
    public void A_file_of_any_name_is_taken_under_a_name_that_can_be_shown(string name)
    {
        if (!OperatingSystem.IsLinux() && name.AsSpan().IndexOfAny(Path.GetInvalidFileNameChars()) >= 0)
        {
            return;
        }

        using var incoming = new Incoming(files: name[0] == '.' ? ".*" : "*.csv");
        incoming.Write(name, "one");
        Assert.Equal(1, incoming.Take());
        var shown = Assert.Single(incoming.Archived.Values).FileName;
        Assert.DoesNotContain(shown, char.IsControl);
        Assert.DoesNotContain('\u202E', shown);
        Assert.EndsWith("csv", shown, StringComparison.Ordinal);
        Assert.Empty(incoming.Files());
    }

    [Fact]
    public void A_name_of_255_bytes_is_taken()
    {
        using var incoming = new Incoming();
        incoming.Write(new string('a', 251) + ".csv", "one");
        Assert.Equal(1, incoming.Take());
        Assert.Equal(255, Assert.Single(incoming.Archived.Values).FileName.Length);
        Assert.Empty(incoming.Files());
    }

    [Fact]
    public void A_name_of_255_bytes_that_is_too_large_is_laid_aside()
    {
        using var incoming = new Incoming(mostBytes: 1);
        incoming.Write(new string('a', 251) + ".csv", "one");
        Assert.Equal(1, incoming.Take());
        Assert.Single(incoming.Unread);
    }

    [Fact]
    public void Two_names_that_look_alike_are_two_arrivals()
    {
        Assert.SkipUnless(OperatingSystem.IsLinux(), "Only Linux has control characters in names.");
        using var incoming = new Incoming();
        incoming.Write("a\u0001.csv", "one");
        incoming.Write("a\u0002.csv", "one");
        incoming.Take();
        Assert.Equal(2, incoming.Archived.Count);
        Assert.Equal(["a\uFFFD.csv", "a\uFFFD.csv"], incoming.Archived.Values.Select(a => a.FileName));
    }

    [Fact]
    public void Links_and_folders_are_named_and_left()
    {
        using var incoming = new Incoming();
        using var elsewhere = new Incoming();
        var secret = elsewhere.Write("secret.csv", "secret");
        File.CreateSymbolicLink(incoming.PathOf("link.csv"), secret);
        File.CreateSymbolicLink(incoming.PathOf("dangling.csv"), incoming.PathOf("nowhere"));
        Directory.CreateSymbolicLink(incoming.PathOf("linked-folder.csv"), elsewhere.Folder);
        Directory.CreateDirectory(incoming.PathOf("folder.csv"));
        incoming.Write("a.csv", "one");
        Assert.Equal(1, incoming.Take());
        Assert.Equal(["a.csv:one"], incoming.Texts);
        Assert.Equal(
            ["dangling.csv: it is a link", "folder.csv: it is a folder", "link.csv: it is a link", "linked-folder.csv: it is a link"],
            incoming.Source.Left.Select(l => $"{l.Name}: {l.Reason.Split(',')[0]}").Order(StringComparer.Ordinal));
        Assert.Equal("secret", File.ReadAllText(secret));
    }

    // With what an earlier run may have left there, and with nothing; the cell's own folder, and the one in it.
    [Theory]
    [InlineData("", false)]
    [InlineData("", true)]
    [InlineData("too-large", false)]
    public void A_link_in_place_of_a_folder_of_the_cells_own_is_not_followed(string inside, bool isOldRun)
    {
        using var incoming = new Incoming(mostBytes: inside.Length > 0 ? 1 : 1_000_000);
        using var elsewhere = new Incoming();
        elsewhere.Write("theirs.csv", "not a measurement");
        if (inside.Length > 0)
        {
            Directory.CreateDirectory(incoming.PathOf(ClaimFolder.Name));
        }

        Directory.CreateSymbolicLink(Path.Combine(incoming.PathOf(ClaimFolder.Name), inside), elsewhere.Folder);
        incoming.Write("a.csv", "one");
        if (isOldRun)
        {
            incoming.Restart();
        }

        Assert.Contains("is a link", Assert.Throws<SourceException>(() => incoming.Take()).Message, StringComparison.Ordinal);
        Assert.Equal(["theirs.csv"], elsewhere.Files());
        Assert.Empty(incoming.Archived);
        Assert.Single(new[] { incoming.PathOf("a.csv"), incoming.Claimed("a.csv") }, File.Exists);
    }

    // Whoever may write there can put a link or a pipe into the place of a file between the look and the reading.
    [Theory]
    [InlineData("link")]
    [InlineData("pipe")]
    [InlineData("folder")]
    public void What_takes_the_place_of_a_file_before_it_is_read_is_not_opened(string kind)
    {
        Assert.SkipUnless(OperatingSystem.IsLinux(), "Pipes with names in folders are those of Linux.");
        using var incoming = new Incoming();
        using var elsewhere = new Incoming();
        var file = new FileInfo(incoming.Write("a.csv", "one"));
        Assert.Equal("one"u8.ToArray(), FileReading.Whole(file));
        file.Delete();
        switch (kind)
        {
            case "link":
                File.CreateSymbolicLink(file.FullName, elsewhere.Write("a.csv", "one"));
                break;
            case "pipe":
                Run("mkfifo", file.FullName);
                break;
            default:
                Directory.CreateDirectory(file.FullName);
                break;
        }

        Assert.Null(FileReading.Whole(file));
        Assert.Null(FileReading.Hash(file, TestContext.Current.CancellationToken));
        Assert.False(EndMark.Ends(file, "one"));
        Assert.Contains(kind, Assert.Throws<NotPlainFileException>(() => PlainFile.Open(file.FullName, FileShare.Read)).Message,
            StringComparison.Ordinal);
    }

    [Fact]
    public void A_pipe_is_named_and_left_without_waiting_for_its_writer()
    {
        Assert.SkipUnless(OperatingSystem.IsLinux(), "Pipes with names in folders are those of Linux.");
        using var incoming = new Incoming(new FinishedByEndMark("END"));
        Run("mkfifo", incoming.PathOf("pipe.csv"));
        incoming.Write("a.csv", "END");
        Assert.Equal(1, incoming.Take());
        Assert.Equal("pipe.csv", Assert.Single(incoming.Source.Left).Name);
    }

    [Fact]
    public void A_name_that_is_not_UTF_8_is_named_and_left()
    {
        Assert.SkipUnless(OperatingSystem.IsLinux(), "Names elsewhere are always text.");
        using var incoming = new Incoming();
        Run("sh", "-c", $"printf one > \"{incoming.Folder}/$(printf 'caf\\351.csv')\"");
        incoming.Write("a.csv", "one");
        Assert.Equal(1, incoming.Take());
        var left = Assert.Single(incoming.Source.Left);
        Assert.Equal("caf\uFFFD.csv", left.Name);
        Assert.Contains("UTF-8", left.Reason, StringComparison.Ordinal);
        Run("sh", "-c", $"rm \"{incoming.Folder}\"/caf*");
    }

    [Fact]
    public void Content_of_any_kind_is_archived_byte_by_byte()
    {
        using var incoming = new Incoming();
        var contents = new byte[][]
        {
            [],
            [0],
            [0xFF, 0xFE],
            [.. "PK\u0003\u0004"u8],
            Encoding.UTF8.GetBytes("point,x_mm,y_mm\n1,NaN,Infinity\n"),
            [.. Enumerable.Range(0, 256).Select(i => (byte)i)],
            new byte[1_000_000]
        };
        for (var i = 0; i < contents.Length; i++)
        {
            File.WriteAllBytes(incoming.PathOf($"{i}.csv"), contents[i]);
        }

        Assert.Equal(contents.Length, incoming.Take());
        Assert.All(incoming.Archived.Values, a => Assert.Equal(contents[a.FileName[0] - '0'], a.Bytes.ToArray()));
    }

    private static void Run(string program, params string[] arguments)
    {
        using var process = Process.Start(new ProcessStartInfo(program, arguments))!;
        process.WaitForExit();
        Assert.Equal(0, process.ExitCode);
    }
}

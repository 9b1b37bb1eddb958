using Avalonia;
using Avalonia.Controls;
using Avalonia.Input;
using Avalonia.Layout;
using Avalonia.Media;
using Avalonia.Media.Imaging;
using Avalonia.VisualTree;
using ErrorMatching.Hmi.Testing;

namespace ErrorMatching.Hmi.Tests;

/// <summary>What ErrorMatching.Hmi.Platform draws and passes on, by pixels and by what controls make of it.</summary>
public sealed class PlatformTests
{
    [Theory]
    [InlineData(1.0)]
    [InlineData(1.5)]
    [InlineData(2.0)]
    public Task A_unit_is_as_many_pixels_as_the_scaling_says(double scaling) => Drawing.Needed().RunAsync(() =>
    {
        OffScreenSession.Scaling = scaling;
        try
        {
            Within(new Border { Width = 100, Background = Brushes.Red, HorizontalAlignment = HorizontalAlignment.Left }, (_, user) =>
            {
                Assert.Equal(Colors.Red, user.PixelAt(new((int)(100 * scaling) - 2, (int)(50 * scaling))));
                Assert.Equal(Colors.Blue, user.PixelAt(new((int)(100 * scaling) + 1, (int)(50 * scaling))));
            });
        }
        finally
        {
            OffScreenSession.Scaling = 1;
        }
    });

    [Fact]
    public Task A_picture_goes_to_PNG_and_back_pixel_by_pixel() => Drawing.Needed().RunAsync(() =>
    {
        using var drawn = new RenderTargetBitmap(new PixelSize(20, 20));
        using (var context = drawn.CreateDrawingContext())
        {
            context.FillRectangle(Brushes.Red, new Rect(0, 0, 10, 20));
        }

        using var png = new MemoryStream();
        drawn.Save(png, PngBitmapEncoderOptions.Default);
        png.Position = 0;
        using var image = new Bitmap(png);
        Within(
            new Image { Source = image, Width = 100, Height = 100, HorizontalAlignment = HorizontalAlignment.Left },
            (_, user) => Assert.Equal([Colors.Red, Colors.Blue, Colors.Blue], new[] { 25, 75, 150 }.Select(x => user.PixelAt(new(x, 50)))));
    });

    [Fact]
    public Task A_stream_that_fails_says_why_a_picture_is_not_read_or_written() => Drawing.Needed().RunAsync(() =>
    {
        using var drawn = new RenderTargetBitmap(new PixelSize(200, 200));
        using var small = new MemoryStream(new byte[100], writable: true);
        Assert.IsType<NotSupportedException>(
            Assert.Throws<IOException>(() => drawn.Save(small, PngBitmapEncoderOptions.Default)).InnerException);
        using var png = new MemoryStream();
        drawn.Save(png, PngBitmapEncoderOptions.Default);
        using var torn = new MemoryStream(png.ToArray()[..40]);
        Assert.IsType<EndOfStreamException>(Assert.Throws<IOException>(() => new Bitmap(torn)).InnerException);
    });

    // After an exception out of the timer that waits, the next wait was seen never to end; why was not traced in Avalonia.
    [Fact]
    public Task A_wait_whose_condition_throws_fails_and_the_next_one_goes_on() =>
        Drawing.Needed().RunAsync(() => Within(new Border(), (_, user) =>
    {
        var looks = 0;
        Assert.Throws<InvalidOperationException>(() => user.WaitFor(() => throw new InvalidOperationException("No."), Seat.Patience));
        user.WaitFor(() => ++looks > 3, Seat.Patience);
        Assert.Equal(4, looks);
    }));

    [Fact]
    public Task Half_opaque_is_half_of_both() => Drawing.Needed().RunAsync(() => Within(
        new Border { Background = Brushes.Red, Opacity = 0.5 },
        (_, user) =>
        {
            var pixel = user.PixelAt(new(100, 50));
            Assert.InRange(pixel.R, 126, 129);
            Assert.InRange(pixel.B, 126, 129);
        }));

    [Fact]
    public Task Keys_edit_and_the_clipboard_keeps() => Drawing.Needed().RunAsync(() =>
    {
        var box = new TextBox();
        Within(box, (_, user) =>
        {
            user.Click(box).Type("abc 測試").Press(Key.Back).Press(Key.Home).Type("X");
            Assert.Equal("Xabc 測", box.Text);
            user.Press(Key.A, RawInputModifiers.Control).Press(Key.X, RawInputModifiers.Control);
            Assert.Equal("", box.Text ?? "");
            user.Press(Key.V, RawInputModifiers.Control).Press(Key.V, RawInputModifiers.Control);
            Assert.Equal("Xabc 測Xabc 測", box.Text);
        });
    });

    [Fact]
    public Task A_finger_presses_a_button() => Drawing.Needed().RunAsync(() =>
    {
        var pressed = 0;
        var button = new Button { Content = "Press" };
        button.Click += (_, _) => pressed++;
        Within(button, (_, user) => user.Tap(button));
        Assert.Equal(1, pressed);
    });

    [Fact]
    public Task A_list_of_a_million_makes_only_what_is_seen() => Drawing.Needed().RunAsync(() =>
    {
        var program = System.Text.Encoding.ASCII.GetBytes(string.Concat(Enumerable.Repeat("G1 X1. Y2.\n", 1_000_000)));
        var list = new ListBox { ItemsSource = new ProgramLines(program, program, []) };
        Within(list, (_, user) =>
        {
            user.Click(list).Press(Key.End);
            Assert.Equal(999_999, list.SelectedIndex);
            Assert.InRange(list.GetVisualDescendants().OfType<ListBoxItem>().Count(), 1, 40);
        });
    });

    private static void Within(Control content, Action<Window, ScreenUser> test)
    {
        var window = new Window { Width = 200, Height = 100, Background = Brushes.Blue, Content = content };
        window.Show();
        try
        {
            test(window, new ScreenUser(window).Settle());
        }
        finally
        {
            window.Close();
        }
    }
}

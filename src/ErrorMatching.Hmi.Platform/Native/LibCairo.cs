using System.Runtime.InteropServices;

namespace ErrorMatching.Hmi.Platform;

/// <summary>The few Cairo entry points that the renderer needs (Debian: libcairo2).</summary>
internal static unsafe partial class LibCairo
{
    public const string Library = "libcairo.so.2";

    public const int FormatArgb32 = 0, FormatA8 = 2;
    public const int OperatorSource = 1, OperatorOver = 2;
    public const int FillWinding = 0, FillEvenOdd = 1;
    public const int ContentColorAlpha = 0x3000;
    public const int FilterFast = 0, FilterGood = 1, FilterBest = 2, FilterNearest = 3;
    public const int ExtendNone = 0, ExtendRepeat = 1, ExtendReflect = 2, ExtendPad = 3;
    public const int AntialiasDefault = 0, AntialiasNone = 1;

    [StructLayout(LayoutKind.Sequential)]
    public struct Mat { public double Xx, Yx, Xy, Yy, X0, Y0; }

    [StructLayout(LayoutKind.Sequential)]
    public struct Glyph { public nuint Index; public double X, Y; }

    [StructLayout(LayoutKind.Sequential)]
    public struct PathData { public int Status; public double* Data; public int Count; }

    [LibraryImport(Library)] public static partial nint cairo_image_surface_create(int format, int width, int height);
    [LibraryImport(Library)]
    public static partial nint cairo_image_surface_create_from_png_stream(
        delegate* unmanaged[Cdecl]<nint, byte*, uint, int> read, nint closure);
    [LibraryImport(Library)]
    public static partial int cairo_surface_write_to_png_stream(
        nint surface, delegate* unmanaged[Cdecl]<nint, byte*, uint, int> write, nint closure);
    [LibraryImport(Library)] public static partial byte* cairo_image_surface_get_data(nint surface);
    [LibraryImport(Library)] public static partial int cairo_image_surface_get_width(nint surface);
    [LibraryImport(Library)] public static partial int cairo_image_surface_get_height(nint surface);
    [LibraryImport(Library)] public static partial int cairo_image_surface_get_stride(nint surface);
    [LibraryImport(Library)] public static partial int cairo_surface_status(nint surface);
    [LibraryImport(Library)] public static partial void cairo_surface_flush(nint surface);
    [LibraryImport(Library)] public static partial void cairo_surface_mark_dirty(nint surface);
    [LibraryImport(Library)] public static partial void cairo_surface_destroy(nint surface);
    [LibraryImport(Library)] public static partial nint cairo_create(nint surface);
    [LibraryImport(Library)] public static partial void cairo_destroy(nint cr);
    [LibraryImport(Library)] public static partial int cairo_status(nint cr);
    [LibraryImport(Library)] public static partial void cairo_save(nint cr);
    [LibraryImport(Library)] public static partial void cairo_restore(nint cr);
    [LibraryImport(Library)] public static partial void cairo_push_group(nint cr);
    [LibraryImport(Library)] public static partial void cairo_pop_group_to_source(nint cr);
    [LibraryImport(Library)] public static partial void cairo_set_operator(nint cr, int op);
    [LibraryImport(Library)] public static partial void cairo_set_antialias(nint cr, int antialias);
    [LibraryImport(Library)] public static partial void cairo_set_matrix(nint cr, in Mat matrix);
    [LibraryImport(Library)] public static partial void cairo_identity_matrix(nint cr);
    [LibraryImport(Library)] public static partial void cairo_set_source_rgba(nint cr, double r, double g, double b, double a);
    [LibraryImport(Library)] public static partial void cairo_set_source(nint cr, nint pattern);
    [LibraryImport(Library)] public static partial void cairo_set_source_surface(nint cr, nint surface, double x, double y);
    [LibraryImport(Library)] public static partial nint cairo_get_source(nint cr);
    [LibraryImport(Library)] public static partial void cairo_paint(nint cr);
    [LibraryImport(Library)] public static partial void cairo_paint_with_alpha(nint cr, double alpha);
    [LibraryImport(Library)] public static partial void cairo_mask(nint cr, nint pattern);
    [LibraryImport(Library)] public static partial void cairo_mask_surface(nint cr, nint surface, double x, double y);
    [LibraryImport(Library)] public static partial void cairo_new_path(nint cr);
    [LibraryImport(Library)] public static partial void cairo_new_sub_path(nint cr);
    [LibraryImport(Library)] public static partial void cairo_move_to(nint cr, double x, double y);
    [LibraryImport(Library)] public static partial void cairo_line_to(nint cr, double x, double y);
    [LibraryImport(Library)]
    public static partial void cairo_curve_to(nint cr, double x1, double y1, double x2, double y2, double x3, double y3);
    [LibraryImport(Library)] public static partial void cairo_close_path(nint cr);
    [LibraryImport(Library)] public static partial void cairo_rectangle(nint cr, double x, double y, double w, double h);
    [LibraryImport(Library)] public static partial void cairo_fill(nint cr);
    [LibraryImport(Library)] public static partial void cairo_stroke(nint cr);
    [LibraryImport(Library)] public static partial void cairo_clip(nint cr);
    [LibraryImport(Library)] public static partial void cairo_set_fill_rule(nint cr, int rule);
    [LibraryImport(Library)] public static partial void cairo_set_line_width(nint cr, double width);
    [LibraryImport(Library)] public static partial void cairo_set_line_cap(nint cr, int cap);
    [LibraryImport(Library)] public static partial void cairo_set_line_join(nint cr, int join);
    [LibraryImport(Library)] public static partial void cairo_set_miter_limit(nint cr, double limit);
    [LibraryImport(Library)] public static partial void cairo_set_dash(nint cr, double[]? dashes, int count, double offset);
    [LibraryImport(Library)] public static partial int cairo_in_fill(nint cr, double x, double y);
    [LibraryImport(Library)] public static partial int cairo_in_stroke(nint cr, double x, double y);
    [LibraryImport(Library)]
    public static partial void cairo_path_extents(nint cr, out double x1, out double y1, out double x2, out double y2);
    [LibraryImport(Library)]
    public static partial void cairo_stroke_extents(nint cr, out double x1, out double y1, out double x2, out double y2);
    [LibraryImport(Library)] public static partial PathData* cairo_copy_path(nint cr);
    [LibraryImport(Library)] public static partial void cairo_path_destroy(PathData* path);
    [LibraryImport(Library)] public static partial nint cairo_pattern_create_linear(double x0, double y0, double x1, double y1);
    [LibraryImport(Library)]
    public static partial nint cairo_pattern_create_radial(double x0, double y0, double r0, double x1, double y1, double r1);
    [LibraryImport(Library)] public static partial nint cairo_pattern_create_for_surface(nint surface);
    [LibraryImport(Library)] public static partial nint cairo_pattern_create_rgba(double r, double g, double b, double a);
    [LibraryImport(Library)]
    public static partial void cairo_pattern_add_color_stop_rgba(nint pattern, double offset, double r, double g, double b, double a);
    [LibraryImport(Library)] public static partial void cairo_pattern_set_extend(nint pattern, int extend);
    [LibraryImport(Library)] public static partial void cairo_pattern_set_filter(nint pattern, int filter);
    [LibraryImport(Library)] public static partial void cairo_pattern_set_matrix(nint pattern, in Mat matrix);
    [LibraryImport(Library)] public static partial void cairo_pattern_destroy(nint pattern);
    [LibraryImport(Library)] public static partial void cairo_set_font_face(nint cr, nint face);
    [LibraryImport(Library)] public static partial void cairo_set_font_size(nint cr, double size);
    [LibraryImport(Library)] public static partial void cairo_glyph_path(nint cr, Glyph* glyphs, int count);
    [LibraryImport(Library)] public static partial nint cairo_ft_font_face_create_for_ft_face(nint face, int loadFlags);
    [LibraryImport(Library)] public static partial void cairo_ft_font_face_set_synthesize(nint face, uint flags);
    [LibraryImport(Library)] public static partial nint cairo_font_options_create();
    [LibraryImport(Library)] public static partial void cairo_font_options_set_hint_style(nint options, int style);
    [LibraryImport(Library)] public static partial void cairo_font_options_set_hint_metrics(nint options, int metrics);
    [LibraryImport(Library)] public static partial void cairo_set_font_options(nint cr, nint options);
}

#include <fmt/format.h>

#include "base/error.h"
#include "render/vector/document_face.h"
#include "render/vector/pdf_canvas.h"
#include "render/vector/pdf_file.h"
#include "render/vector/pdf_font.h"
#include "render/vector/pdf_picture.h"
#include "render/vector/short_number.h"
#include "render/vector/vector_document.h"

namespace tribolog::render {
namespace {

constexpr double points_per_mm = 72.0 / 25.4;

/// Fonts, transparency and the picture below, by the names that the content uses.
std::string resources_of(PdfFile& file, const std::vector<DocumentFace>& faces,
                         const PdfCanvas& canvas, const std::vector<std::byte>& solid_parts) {
  std::string fonts;
  for (const DocumentFace& face : faces) {
    fonts +=
        fmt::format("{} {} ", pdf_font_name(face.weight()), pdf_reference(add_font(file, face)));
  }
  std::string states;
  for (const int alpha : canvas.alphas()) {
    const std::string share = short_number(alpha / 255.0, 4);
    states += fmt::format("/A{} << /ca {} /CA {} >> ", alpha, share, share);
  }
  std::string out = fmt::format("<< /Font << {}>> /ExtGState << {}>>", fonts, states);
  if (!solid_parts.empty()) {
    out += fmt::format(" /XObject << /Solid {} >>", pdf_reference(add_picture(file, solid_parts)));
  }
  return out + " >>";
}

}  // namespace

std::string pdf_document(const DrawList& list, const DocumentTexts& texts, const Font& font,
                         const std::vector<std::byte>& solid_parts) {
  if (list.scene && solid_parts.empty()) {
    throw FigureError("the solid parts of a scene have to be drawn before they are put into PDF");
  }
  const double scale = points_per_mm * list.width_mm / list.width;
  const std::string width = short_number(scale * list.width, 3);
  const std::string height = short_number(scale * list.height, 3);
  const std::vector<DocumentFace> faces = document_faces(list, font);
  PdfCanvas canvas(faces);
  paint_on(canvas, list);
  std::string content = fmt::format("/Figure << /MCID 0 >> BDC\nq\n{0} 0 0 -{0} 0 {1} cm\n1 j\n",
                                    short_number(scale, 6), height);
  if (!solid_parts.empty()) {
    content += fmt::format("q {0} 0 0 -{1} 0 {1} cm /Solid Do Q\n", list.width, list.height);
  }
  content += canvas.content() + "Q\nEMC\n";

  PdfFile file;
  const int catalogue = file.reserve();
  const int pages = file.reserve();
  const int page = file.reserve();
  const int structure = file.reserve();
  const int figure = file.reserve();
  file.write(catalogue,
             fmt::format("<< /Type /Catalog /Pages {} /Lang (en) /MarkInfo << /Marked true >> "
                         "/StructTreeRoot {} /ViewerPreferences << /DisplayDocTitle true >> >>",
                         pdf_reference(pages), pdf_reference(structure)));
  file.write(pages, fmt::format("<< /Type /Pages /Kids [{}] /Count 1 >>", pdf_reference(page)));
  file.write(structure,
             fmt::format("<< /Type /StructTreeRoot /K [{0}] /ParentTree << /Nums [0 [{0}]] >> >>",
                         pdf_reference(figure)));
  file.write(figure,
             fmt::format("<< /Type /StructElem /S /Figure /P {} /Pg {} /K 0 /T {} /Alt {} "
                         "/A << /O /Layout /Placement /Block /BBox [0 0 {} {}] >> >>",
                         pdf_reference(structure), pdf_reference(page), pdf_text(texts.title),
                         pdf_text(texts.description), width, height));
  const int drawn = file.add_stream(content);
  file.write(page, fmt::format("<< /Type /Page /Parent {} /MediaBox [0 0 {} {}] /Contents {} "
                               "/StructParents 0 /Group << /S /Transparency /CS /DeviceRGB >> "
                               "/Resources {} >>",
                               pdf_reference(pages), width, height, pdf_reference(drawn),
                               resources_of(file, faces, canvas, solid_parts)));
  const int information =
      file.add(fmt::format("<< /Title {} /Producer (tribolog) >>", pdf_text(texts.title)));
  return file.finish(catalogue, information);
}

}  // namespace tribolog::render
